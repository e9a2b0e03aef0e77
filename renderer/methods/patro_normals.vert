// A normal for each colour channel, placed as the surface's own is.

layout(location = 2) in vec3 channel_normal[3];

out vec3 red_normal;
out vec3 green_normal;
out vec3 blue_normal;

void main() {
    place_vertex();
    mat3 world_from_normal = mat3(world_from_object_normal);
    red_normal = unit(world_from_normal * channel_normal[0]);
    green_normal = unit(world_from_normal * channel_normal[1]);
    blue_normal = unit(world_from_normal * channel_normal[2]);
}
