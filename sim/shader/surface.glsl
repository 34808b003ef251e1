// What a reflectance model is given: the cosines between the directions at a point, the exponent
// and F0. A model is one file beside this one, with the function
//
//     float highlight(cosines c)      // what light.glsl multiplies the highlight's colour by
//
// as sim/reflectance has it under the same name (docs/shaders.md). A uniform that a model declares
// itself takes a search, an integral or a table to find; it is set before the frame.
struct cosines {
    float nl, nv, nh, rv, vh; // N.L, N.V, N.H, R.V, V.H
};

const float pi = 3.14159265358979;

uniform float n;

// A cosine held in 0 to 1.
float held(float c)
{
    return clamp(c, 0.0, 1.0);
}
