// cos^(2^k), k = log2 n rounded, by squaring k times.
float highlight(cosines c)
{
    float value = held(c.nh);
    int squarings = int(floor(log2(n) + 0.5));
    for (int i = 0; i < squarings; i++)
        value *= value;
    return value;
}
