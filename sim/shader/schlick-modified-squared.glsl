// Schlick's, modified (2.2) with the square on n too: 0.5 (n(1 - c))^2.
float highlight(cosines c)
{
    float x = held(c.nh);
    float d = n * (1.0 - x);
    return x / (x + d + 0.5 * d * d);
}
