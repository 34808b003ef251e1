// Lyon's, k = 8, of equal integral: (w/8 (c-1) + 1)^8 with w/8 = (n+1)/9.
float highlight(cosines c)
{
    float value = max((n + 1.0) / 9.0 * (held(c.nh) - 1.0) + 1.0, 0.0);
    value *= value;
    value *= value;
    value *= value;
    return value;
}
