// Phong's model and light through the same thickness everywhere.

layout(std140, binding = 1) uniform Constant {
    float thickness; // mm
};

in vec3 world_position;
in vec3 world_normal;
out vec4 colour;

void main() {
    vec3 light = phong(unit(world_normal), world_position);
    for (int i = 0; i < LIGHTS; ++i)
        light += scatter(i, thickness, world_position);
    colour = vec4(light, 1.0);
}
