// Cook and Torrance's, with Beckmann's facets: pi (N.L) F D G / (4 (N.L)(N.V)), the Rs of (1.4)
// up to a factor. m = sqrt(2/(n+2)).
uniform float f0; // F at normal incidence; 1 is a mirror

// Fresnel's, for unpolarised light on a plane boundary.
float fresnel(float x)
{
    if (f0 >= 1.0)
        return 1.0;
    float root = sqrt(f0);
    float refraction = (1.0 + root) / (1.0 - root);
    float g = sqrt(refraction * refraction - 1.0 + x * x);
    float s = (g - x) / (g + x);
    float p = (x * (g + x) - 1.0) / (x * (g - x) + 1.0);
    return 0.5 * s * s * (1.0 + p * p);
}

// What its V-shaped neighbours leave of a facet, divided by (N.L)(N.V).
float shown(cosines c)
{
    float larger = max(c.nl, c.nv), smaller = min(c.nl, c.nv);
    return 2.0 * c.nh * smaller < c.vh ? 2.0 * c.nh / (c.vh * larger) : 1.0 / (larger * smaller);
}

float facets_at(float x)
{
    float m2 = 2.0 / (n + 2.0);
    float cos2 = x * x;
    return exp(-(1.0 - cos2) / cos2 / m2) / (pi * m2 * cos2 * cos2);
}

float highlight(cosines c)
{
    if (c.nl <= 0.0 || c.nv <= 0.0)
        return 0.0;
    return pi * c.nl * 0.25 * fresnel(held(c.vh)) * facets_at(held(c.nh)) * shown(c);
}
