// Schlick's, modified as Table 3.2 has it: c^a/(n - nc + c).
uniform float a; // the best for n: the least relative error in the epicentre

float highlight(cosines c)
{
    float x = held(c.nh);
    return pow(x, a) / (x + n * (1.0 - x));
}
