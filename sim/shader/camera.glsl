// From the object to the frame, as sim/render/camera.h has it. Rows run downwards, so that row 0 of
// the frame is its top one.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 direction; // the normal

uniform mat3 view;   // of points, into the camera's axes and from the eye
uniform vec3 place;  // of the object's origin, from the eye
uniform mat3 turn;   // of normals, into the camera's axes
uniform vec2 lens;   // focal length / half of the frame's width, height
uniform float near;  // of the near plane

// A point from the eye: x right, y up, z towards the viewer.
vec3 from_eye()
{
    return view * position + place;
}

// Depth is 1 - near/w in the clipping volume, whose far side is never reached.
vec4 on_frame(vec3 p)
{
    float w = -p.z;
    return vec4(p.x * lens.x, -p.y * lens.y, w - 2.0 * near, w);
}
