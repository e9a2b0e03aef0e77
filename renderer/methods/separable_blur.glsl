// One axis of the diffusion blur, in mm on the surface.  TAPS samples.

layout(std140, binding = 2) uniform Diffusion {
    vec4 depth_axis; // depth along the camera's axis, mm, from a place in the world
    vec4 scale;      // xy pixels to a mm where clip w is 1; w there is z * depth + w
    vec4 tail;       // rgb: decay length of the profile's wide part, mm
    ivec4 corner;    // xy: of the viewport
    vec4 tap[TAPS];  // rgb: weight; w: offset in mm
};

layout(binding = 8) uniform sampler2D blurred_from;

// What a pixel adds: its own light as far as the profile reaches around a step in depth, the
// middle's for the rest, so that light neither jumps across gaps nor is lost.
vec3 share(ivec2 pixel, vec4 middle, float offset) {
    ivec2 size = textureSize(blurred_from, 0);
    bool outside = any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size));
    vec4 there = outside ? vec4(0.0) : texelFetch(blurred_from, pixel, 0);
    if (there.a == 0.0)
        return middle.rgb;
    float step_in_depth = there.a - middle.a;
    float detour = sqrt(offset * offset + step_in_depth * step_in_depth) - abs(offset);
    return mix(middle.rgb, there.rgb, exp(-detour / max(tail.rgb, 1e-12)));
}

vec4 blurred(ivec2 pixel, ivec2 axis) {
    vec4 middle = texelFetch(blurred_from, pixel, 0);
    if (middle.a == 0.0)
        return vec4(0.0);
    float pixels = dot(scale.xy, vec2(axis)) / (scale.z * middle.a + scale.w);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < TAPS; ++i) {
        float way = tap[i].w * pixels, whole = floor(way);
        ivec2 near = pixel + int(whole) * axis;
        sum += tap[i].rgb * mix(share(near, middle, tap[i].w),
                                share(near + axis, middle, tap[i].w), way - whole);
    }
    return vec4(sum, middle.a);
}
