// The quadratic (2.3): ac^2 + (1-a)c, 0 where it is negative.
uniform float a; // (2.8)

float highlight(cosines c)
{
    float x = held(c.nh);
    return x * max(1.0 - a * (1.0 - x), 0.0);
}
