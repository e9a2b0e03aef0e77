// Smoothed irradiance in the place of the clamped cosine; three bands may dip below 0.

in vec3 world_position;
in vec3 world_normal;
in vec3 irradiance[LIGHTS];
out vec4 colour;

void main() {
    vec3 V = unit(eye.xyz - world_position);
    vec3 N = unit(world_normal);
    vec3 light = ambient();
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 L = toward_light(i, world_position);
        light += I_p(i, world_position) * k_di.rgb * max(irradiance[i], vec3(0.0)) +
                 highlight(i, N, L, V, world_position);
    }
    colour = vec4(light, 1.0);
}
