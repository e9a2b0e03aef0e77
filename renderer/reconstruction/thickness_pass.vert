// Thickness toward every light from spherical harmonics, per vertex.  [SHSS, eq. 2]
// SLOTS is the number of inputs the used bands fill: bands 0 and 1 share the first, every later band
// begins a new input, and the rest of its last input meets zeros.

layout(location = 0) in vec3 position; // object space
layout(location = 2) in vec4 c[SLOTS];

#ifdef BLOCKS
// Centre (lower half) and step of every component, slot by slot for all BLOCKS blocks.
layout(std430, binding = 0) readonly buffer Ranges {
    uvec4 range[];
};

vec4 component(int i) {
    uvec4 word = range[i * BLOCKS + gl_VertexID / BLOCK_VERTICES];
    vec2 x = unpackHalf2x16(word.x), y = unpackHalf2x16(word.y);
    vec2 z = unpackHalf2x16(word.z), w = unpackHalf2x16(word.w);
    return vec4(x.x, y.x, z.x, w.x) + vec4(x.y, y.y, z.y, w.y) * c[i];
}
#else
vec4 component(int i) {
    return c[i];
}
#endif

layout(std140, binding = 1) uniform Lights {
    vec4 y[LIGHTS * SLOTS];  // toward a far light, scaled: mm
#ifdef POINT_LIGHTS
    vec4 near[LIGHTS];       // xyz: where a near light stands, object space; w: 1 for near
    vec4 scale[SLOTS];       // of the coefficients: model units
    mat4 world_from_model;   // its linear part, mm to a model unit
    vec4 model_per_object;   // x: model units to an object unit
#endif
};

out float thickness[LIGHTS]; // mm

#ifdef POINT_LIGHTS
// At most the way to the light, when it stands inside.
float toward_near(vec3 place, vec4 stored[SLOTS]) {
    vec3 way = place - position;
    float distance = length(way);
    vec3 s = way / max(distance, 1e-15);
    vec4 basis[SLOTS];
    evaluate(s, basis);
    float d = 0.0;
    for (int i = 0; i < SLOTS; ++i)
        d += dot(stored[i] * scale[i], basis[i]);
    return min(d, distance * model_per_object.x) * length(mat3(world_from_model) * s);
}
#endif

void main() {
    vec4 stored[SLOTS];
    for (int i = 0; i < SLOTS; ++i)
        stored[i] = component(i);
    for (int k = 0; k < LIGHTS; ++k) {
        thickness[k] = 0.0;
        for (int i = 0; i < SLOTS; ++i)
            thickness[k] += dot(stored[i], y[k * SLOTS + i]);
#ifdef POINT_LIGHTS
        if (near[k].w == 1.0)
            thickness[k] = toward_near(near[k].xyz, stored);
#endif
    }
}
