// The mesh seen by the light, in parallel projection: depth is linear.

layout(location = 0) in vec3 position;

layout(std140, binding = 0) uniform LightPass {
    mat4 light_clip_from_object;
};

void main() {
    gl_Position = light_clip_from_object * vec4(position, 1.0);
}
