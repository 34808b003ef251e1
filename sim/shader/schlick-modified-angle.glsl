// Schlick's, modified (2.2) with the square on the angle: 0.5 n(1 - cos(angle^2)), which is
// n sin^2(angle^2/2).
float highlight(cosines c)
{
    float x = held(c.nh);
    float angle = acos(x);
    float sine = sin(0.5 * angle * angle);
    return x / (x + n * (1.0 - x + sine * sine));
}
