// Lyon's, k = 4, of equal integral: (w/4 (c-1) + 1)^4 with w/4 = (n+1)/5.
float highlight(cosines c)
{
    float value = max((n + 1.0) / 5.0 * (held(c.nh) - 1.0) + 1.0, 0.0);
    value *= value;
    value *= value;
    return value;
}
