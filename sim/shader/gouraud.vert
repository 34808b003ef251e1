// Gouraud shading: light at each vertex. INTERPOLATION is noperspective, on the screen, or smooth,
// on the object.
INTERPOLATION out vec3 levels;

void main()
{
    vec3 p = from_eye();
    levels = light(turn * direction, -p);
    gl_Position = on_frame(p);
}
