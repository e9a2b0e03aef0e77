// Where a vertex goes: the same expression in every method, so that their pixels agree.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

out vec3 world_position;
out vec3 world_normal;
invariant gl_Position;

void place_vertex() {
    gl_Position = clip_from_object * vec4(position, 1.0);
    world_position = (world_from_object * vec4(position, 1.0)).xyz;
    world_normal = unit(mat3(world_from_object_normal) * normal);
}
