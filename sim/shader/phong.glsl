// Phong's (1.6), (2.9): (R.V)^n. 0^0 is 1, which pow() does not promise.
float highlight(cosines c)
{
    return n > 0.0 ? pow(held(c.rv), n) : 1.0;
}
