// The mesh as one face of a light's view sees it.

layout(location = 0) in vec3 position;

out vec3 world_position;

void main() {
    world_position = (world_from_object * vec4(position, 1.0)).xyz;
    gl_Position = clip_from_world(pass.light, pass.face, world_position);
}
