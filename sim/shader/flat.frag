// Flat shading: the triangle's colour.
flat in vec3 levels;

void main()
{
    show(levels);
}
