// Phong's model and light through the interpolated thickness.  [SHSS, eq. 3]

in vec3 world_position;
in vec3 world_normal;
in float thickness;
out vec4 colour;

void main() {
    vec3 N = unit(world_normal);
    colour = vec4(phong(N, unit(eye.xyz - world_position)) + scatter(thickness), 1.0);
}
