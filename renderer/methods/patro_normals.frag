// Phong's model with diffuse normals of their own; the highlight keeps the surface's.

in vec3 world_position;
in vec3 world_normal;
in vec3 red_normal;
in vec3 green_normal;
in vec3 blue_normal;
out vec4 colour;

void main() {
    vec3 V = unit(eye.xyz - world_position);
    vec3 N = unit(world_normal);
    vec3 N_r = unit(red_normal);
    vec3 N_g = unit(green_normal);
    vec3 N_b = unit(blue_normal);
    vec3 light = ambient();
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 L = toward_light(i, world_position);
        vec3 cosines = max(vec3(dot(N_r, L), dot(N_g, L), dot(N_b, L)), vec3(0.0));
        light += I_p(i, world_position) * k_di.rgb * cosines +
                 highlight(i, N, L, V, world_position);
    }
    colour = vec4(light, 1.0);
}
