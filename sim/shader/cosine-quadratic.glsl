// The cosine-quadratic (2.15): ((n+1)/3 (c-1) + 1)^2, 0 where the base is negative.
float highlight(cosines c)
{
    float line = max((n + 1.0) / 3.0 * (held(c.nh) - 1.0) + 1.0, 0.0);
    return line * line;
}
