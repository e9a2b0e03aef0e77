// Two pictures in linear light become the code values of a display: the light itself, a thickness,
// or a difference.  Slow twin: false_colours.cpp.

layout(binding = 0) uniform sampler2D left_picture;
layout(binding = 1) uniform sampler2D right_picture;
layout(std140, binding = 0) uniform Show {
    vec4 place; // x, y: the rectangle's corner, pixels; z: where the right side begins, pixels from
                // the corner; w: 1 where a line is drawn there
    vec4 scale; // x: 0 light, 1 thickness, 2 difference; y: the scale's whole; z: the probe's reach,
                // mm; w: surround, linear
    vec4 colours[256];
};
out vec4 code;

vec3 srgb(vec3 light) {
    vec3 clipped = clamp(light, 0.0, 1.0);
    vec3 curve = 1.055 * pow(clipped, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * clipped, lessThanEqual(clipped, vec3(0.0031308)));
}

vec3 false_colour(float value) {
    return colours[int(clamp(value / scale.y, 0.0, 1.0) * 255.0 + 0.5)].rgb;
}

// Stripes where a value is not to be had.
vec3 unknown(vec2 pixel) {
    return mod(pixel.x + pixel.y, 12.0) < 6.0 ? vec3(0.10) : vec3(0.16);
}

vec3 thickness_colour(vec4 probe, vec2 pixel) {
    bool one_length = abs(probe.g * probe.g - probe.r * probe.b) <= 1e-3 * probe.g * probe.g;
    if (!(probe.b > 0.0) || !one_length)
        return unknown(pixel);
    return false_colour(max(scale.z * log(probe.r / probe.g), 0.0));
}

vec3 difference_colour(vec4 left, vec4 right) {
    vec3 apart = abs(left.rgb - right.rgb);
    return false_colour(max(apart.r, max(apart.g, apart.b)));
}

void main() {
    vec2 pixel = gl_FragCoord.xy - place.xy;
    ivec2 texel = ivec2(pixel);
    vec4 left = texelFetch(left_picture, texel, 0);
    vec4 right = texelFetch(right_picture, texel, 0);
    vec4 here = pixel.x < place.z ? left : right;
    vec3 light = here.rgb + (1.0 - here.a) * scale.w;
    if (scale.x == 1.0)
        light = here.a > 0.0 ? thickness_colour(here, pixel) : vec3(scale.w);
    else if (scale.x == 2.0)
        light = max(left.a, right.a) > 0.0 ? difference_colour(left, right) : vec3(scale.w);
    if (place.w == 1.0 && abs(pixel.x - place.z) < 1.0)
        light = vec3(0.9);
    code = vec4(srgb(light), 1.0);
}
