// The light that goes through the body, before it is blurred: all of the paper's terms but the
// highlight.  Alpha is the depth along the camera's axis in mm.

in vec3 world_position;
in vec3 world_normal;
out vec4 body;

void main() {
    vec3 N = unit(world_normal);
    vec3 sum = ambient();
    for (int i = 0; i < LIGHTS; ++i) {
        float cosine = max(dot(N, toward_light(i, world_position)), 0.0);
        sum += I_p(i, world_position) * k_di.rgb * cosine +
               scatter(i, thickness(i, N, world_position), world_position);
    }
    body = vec4(sum, dot(depth_axis, vec4(world_position, 1.0)));
}
