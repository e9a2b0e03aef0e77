// Phong's model and light through a thickness read from every light's map.  [Green2004]

in vec3 world_position;
in vec3 world_normal;
out vec4 colour;

void main() {
    vec3 N = unit(world_normal);
    vec3 sum = phong(N, world_position);
    for (int i = 0; i < LIGHTS; ++i)
        sum += scatter(i, thickness(i, N, world_position), world_position);
    colour = vec4(sum, 1.0);
}
