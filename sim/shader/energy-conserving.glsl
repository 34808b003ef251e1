// The cosine-quadratic, normalised (2.26): (n+6)/24.55 ((n+1)/3 (c-1) + 1)^2.
float highlight(cosines c)
{
    float line = max((n + 1.0) / 3.0 * (held(c.nh) - 1.0) + 1.0, 0.0);
    return (n + 6.0) / 24.55 * line * line;
}
