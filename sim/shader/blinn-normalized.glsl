// Blinn's, normalised (figure 2.16): (n+6)/(8 pi) (N.H)^n. 0^0 is 1.
float highlight(cosines c)
{
    return (n + 6.0) / (8.0 * pi) * (n > 0.0 ? pow(held(c.nh), n) : 1.0);
}
