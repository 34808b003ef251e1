// The thesis's bump-mapped gold (appendix A, lines 544 to 581 of the listing), its vertex shader.
//
// Slips of the listing, not followed: its matrices of 4x4 multiply vectors of three, and points and
// directions alike (569, 571 to 573), where here points are moved and directions turned; what comes
// of that is cut from four components to three without a word (550, 569); both shaders are called
// main in one text. A mesh of Glint's has no tangents: they are x and z along the surface, the
// directions of the map, which is laid on from above (567, 568).
uniform vec3 middle; // of the object
uniform float units; // of the listing's in one of the object's

out vec2 on_map;
out vec3 to_light; // in the surface's own axes: tangent, binormal, normal

void main()
{
    vec3 p = from_eye();
    vec3 tangent = vec3(1.0, 0.0, 0.0) - direction * direction.x;
    vec3 binormal = vec3(0.0, 0.0, 1.0) - direction * direction.z;
    on_map = (position - middle).xz * units * 0.0065 + 0.46;
    vec3 light = -p; // the camera is the light as well
    to_light = vec3(dot(light, turn * tangent), dot(light, turn * binormal),
                    dot(light, turn * direction));
    gl_Position = on_frame(p);
}
