// Radiance that leaves the body, interpolated; of Phong's model the ambient and specular terms.  What
// enters and leaves again is the body's diffuse reflection already.

in vec3 world_position;
in vec3 world_normal;
in vec3 body;
out vec4 colour;

void main() {
    vec3 N = unit(world_normal), V = unit(eye.xyz - world_position);
    vec3 light = ambient() + body;
    for (int i = 0; i < LIGHTS; ++i)
        light += highlight(i, N, toward_light(i, world_position), V, world_position);
    colour = vec4(light, 1.0);
}
