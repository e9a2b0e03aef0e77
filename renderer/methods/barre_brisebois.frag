// Phong's model and a lobe of light through the local thickness.  [BarreBrisebois2011]

layout(std140, binding = 1) uniform Lobe {
    float distortion;
    float power;
    float lobe_scale;
    float around;
};

in vec3 world_position;
in vec3 world_normal;
in float thickness;
out vec4 colour;

void main() {
    vec3 N = unit(world_normal), V = unit(eye.xyz - world_position);
    vec3 sum = phong(N, world_position);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 L = toward_light(i, world_position);
        float along = clamp(dot(V, -(L + N * distortion)), 0.0, 1.0);
        sum += (pow(along, power) * lobe_scale + around) * scatter(i, thickness, world_position);
    }
    colour = vec4(sum, 1.0);
}
