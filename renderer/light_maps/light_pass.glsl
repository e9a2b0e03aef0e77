// Which layer of which light's map is drawn.

struct Pass {
    int light;
    int face;
    int layer;    // in the map
    int peeling;  // 1: only what lies behind the layer before
    int mirrored; // 1: the placement turns triangles around
};

layout(std140, binding = 0) uniform LightPass {
    mat4 world_from_object;
    Pass pass;
};
