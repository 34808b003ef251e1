// The thesis's bump-mapped gold (appendix A, lines 545 to 554 of the listing), its pixel shader: the
// base colour and a highlight of gold by one cosine. The listing gives no value for Gold.
uniform sampler2D base_map;
uniform sampler2D bump_map;

const vec3 gold = vec3(1.0, 0.77, 0.34);

in vec2 on_map;
in vec3 to_light;

void main()
{
    vec3 base = texture(base_map, on_map).rgb;
    vec3 bump = texture(bump_map, on_map).rgb * 2.0 - 1.0;
    float shine = clamp(dot(normalize(to_light), normalize(bump)), 0.0, 1.0);
    show(floor(255.0 * min(shine * 0.2 * base + shine * shine * gold, 1.0) + 0.5));
}
