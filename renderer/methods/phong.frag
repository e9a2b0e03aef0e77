// Phong's model, normals interpolated.

in vec3 world_position;
in vec3 world_normal;
out vec4 colour;

void main() {
    colour = vec4(phong(unit(world_normal), world_position), 1.0);
}
