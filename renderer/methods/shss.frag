// Phong's model and light through the interpolated thickness.  [SHSS, eq. 3]

in vec3 world_position;
in vec3 world_normal;
in float thickness[LIGHTS];
out vec4 colour;

void main() {
    vec3 light = phong(unit(world_normal), world_position);
    for (int i = 0; i < LIGHTS; ++i)
        light += scatter(i, thickness[i], world_position);
    colour = vec4(light, 1.0);
}
