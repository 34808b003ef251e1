// Light at a point, in levels of 0 to 255: C (Ka Ia + Kd Ie N.L) + Ie Ks highlight S, rounded where
// Glint's rasterizer rounds (docs/frames.md): the base, the highlight, then a sum held at 255.
uniform vec3 light_direction; // L, of unit length, in the camera's axes
uniform vec3 ambient;         // C Ka Ia, in levels
uniform vec3 lambert;         // C Kd Ie
uniform vec3 registers;       // S Ie Ks, rounded: registers 3 to 5 of the device

const float tiny = 1e-37;     // makes a cosine of nothing 0 instead of 0/0
const float value_max = 1e6;  // beyond white with any colour

vec3 level(vec3 value)
{
    return min(floor(value + 0.5), 255.0);
}

// normal and to_eye: of any length.
vec3 light(vec3 normal, vec3 to_eye)
{
    vec3 v = to_eye / sqrt(dot(to_eye, to_eye) + tiny);
    vec3 h = light_direction + v;
    float hh = dot(h, h);
    float nn = dot(normal, normal);
    float length_n = sqrt(nn + tiny);
    float nl = dot(normal, light_direction);
    float nv = dot(normal, v);
    cosines c = cosines(nl / length_n, nv / length_n, dot(normal, h) / sqrt(nn * hh + tiny),
                        2.0 * nl * nv / (nn + tiny) - dot(light_direction, v), 0.5 * sqrt(hh));
    vec3 base = level(ambient + lambert * max(c.nl, 0.0));
    if (nl <= 0.0)
        return base;
    return min(base + level(min(highlight(c), value_max) * registers), 255.0);
}
