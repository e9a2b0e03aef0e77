// What leaves the body at a vertex, worked out beforehand.

layout(location = 2) in float radiance[3];
out vec3 body;

void main() {
    place_vertex();
    body = vec3(radiance[0], radiance[1], radiance[2]);
}
