// Phong shading: the normal is interpolated on the object.
out vec3 normal;

void main()
{
    normal = turn * direction;
    gl_Position = on_frame(from_eye());
}
