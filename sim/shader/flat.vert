// Flat shading: the corners; flat.geom lights the triangle.
out vec3 corner;

void main()
{
    corner = from_eye();
    gl_Position = on_frame(corner);
}
