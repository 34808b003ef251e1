// Phong shading: light at each pixel. V is the way back along the ray through its centre.
uniform vec2 half_frame;  // in pixels
uniform float inv_focal;

in vec3 normal;

void main()
{
    vec2 off = (gl_FragCoord.xy - half_frame) * inv_focal;
    show(light(normal, vec3(-off.x, off.y, 1.0)));
}
