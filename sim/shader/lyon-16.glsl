// Lyon's, k = 16, of equal integral: (w/16 (c-1) + 1)^16 with w/16 = (n+1)/17.
float highlight(cosines c)
{
    float value = max((n + 1.0) / 17.0 * (held(c.nh) - 1.0) + 1.0, 0.0);
    value *= value;
    value *= value;
    value *= value;
    value *= value;
    return value;
}
