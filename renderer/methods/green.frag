// Phong's model and light through a thickness read from every light's depth map.  [Green2004]

layout(binding = 0) uniform sampler2D nearest_to_light[LIGHTS]; // z over depth_range; 1: nothing
layout(std140, binding = 1) uniform Maps {
    mat4 light_from_world[8]; // x, y in -1..1 over the map; z in mm from the plane nearest the light
    float texel;              // mm
    float depth_range;        // mm
};

in vec3 world_position;
in vec3 world_normal;
out vec4 colour;

// Depth behind the first surface the light meets.  A point of that surface lies up to a texel times
// its slope behind the depth stored for its texel: that much is not counted.
float thickness(int i, vec3 N) {
    vec3 here = (light_from_world[i] * vec4(world_position, 1.0)).xyz;
    ivec2 size = textureSize(nearest_to_light[i], 0);
    ivec2 place = clamp(ivec2(floor((here.xy * 0.5 + 0.5) * vec2(size))), ivec2(0), size - 1);
    float stored = texelFetch(nearest_to_light[i], place, 0).r;
    if (stored == 1.0)
        return 0.0;
    float cosine = abs(dot(N, light[i].xyz));
    float tangent = sqrt(max(1.0 - cosine * cosine, 0.0)) / max(cosine, 1e-6);
    float bias = texel * min(tangent, 4.0);
    return max(here.z - stored * depth_range - bias, 0.0);
}

void main() {
    vec3 N = unit(world_normal);
    vec3 sum = phong(N, world_position);
    for (int i = 0; i < LIGHTS; ++i)
        sum += scatter(i, thickness(i, N), world_position);
    colour = vec4(sum, 1.0);
}
