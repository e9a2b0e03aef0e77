// The second axis where the surface is drawn, and the highlights on it.

in vec3 world_position;
in vec3 world_normal;
out vec4 colour;

void main() {
    vec3 N = unit(world_normal), V = unit(eye.xyz - world_position);
    vec3 sum = blurred(ivec2(gl_FragCoord.xy) - corner.xy, ivec2(0, 1)).rgb;
    for (int i = 0; i < LIGHTS; ++i)
        sum += highlight(i, N, toward_light(i, world_position), V, world_position);
    colour = vec4(sum, 1.0);
}
