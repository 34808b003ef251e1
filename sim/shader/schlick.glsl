// Schlick's (1.5), (2.1): c/(n - nc + c).
float highlight(cosines c)
{
    float x = held(c.nh);
    float d = n * (1.0 - x);
    return x / (x + d);
}
