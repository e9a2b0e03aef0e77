// The mesh as one face of a light's view sees it.  LINEAR: the light is far, and depths are linear
// over triangles.

layout(location = 0) in vec3 position;

out vec3 world_position;

void main() {
    world_position = (world_from_object * vec4(position, 1.0)).xyz;
    gl_Position = clip_from_world(pass.light, pass.face, world_position);
#ifdef LINEAR
    float part = light_depth(pass.light, world_position) / view[pass.light].extent.x;
    gl_Position.z = (2.0 * part - 1.0) * gl_Position.w;
#endif
}
