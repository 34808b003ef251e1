// A pixel of the frame: its colour in levels, alpha as the object's mask, and near/w as its depth,
// larger for nearer, which keeps single precision at any distance.
uniform float near;

out vec4 pixel;

void show(vec3 levels)
{
    pixel = vec4(levels / 255.0, 1.0);
    gl_FragDepth = near * gl_FragCoord.w;
}
