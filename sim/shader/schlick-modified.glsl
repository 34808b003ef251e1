// Schlick's, modified (2.2) as printed: 0.5 n(1 - c^2) in the denominator as well.
float highlight(cosines c)
{
    float x = held(c.nh);
    float d = n * (1.0 - x);
    return x / (x + d + 0.5 * d * (1.0 + x));
}
