// Blinn's (2.11): (N.H)^n. 0^0 is 1, which pow() does not promise.
float highlight(cosines c)
{
    return n > 0.0 ? pow(held(c.nh), n) : 1.0;
}
