// Lyon's, k = 16, with the least error against c^n: (slope (c-1) + 1)^16.
uniform float slope; // w/16, by a search

float highlight(cosines c)
{
    float value = max(slope * (held(c.nh) - 1.0) + 1.0, 0.0);
    value *= value;
    value *= value;
    value *= value;
    value *= value;
    return value;
}
