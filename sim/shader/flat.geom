// Flat shading: light once for each triangle, at its centroid with the normal of its plane.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in vec3 corner[];
flat out vec3 levels;

void main()
{
    vec3 plane = cross(corner[1] - corner[0], corner[2] - corner[0]);
    vec3 lit = light(plane, -(corner[0] + corner[1] + corner[2]) / 3.0);
    for (int i = 0; i < 3; i++) {
        levels = lit;
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
