// Gouraud shading: the interpolated colour, rounded.
INTERPOLATION in vec3 levels;

void main()
{
    show(floor(levels + 0.5));
}
