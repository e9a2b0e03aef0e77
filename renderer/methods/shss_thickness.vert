// Thickness toward every light from spherical harmonics, per vertex.  [SHSS, eq. 2]
// SLOTS is the number of inputs the used bands fill: bands 0 and 1 share the first, every later band
// begins a new input, and the rest of its last input meets zeros.

layout(location = 0) in vec3 position; // object space
layout(location = 2) in vec4 c[SLOTS];

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
float toward_near(vec3 place) {
    vec3 way = place - position;
    float distance = length(way);
    vec3 s = way / max(distance, 1e-15);
    vec4 basis[SLOTS];
    evaluate(s, basis);
    float d = 0.0;
    for (int i = 0; i < SLOTS; ++i)
        d += dot(c[i] * scale[i], basis[i]);
    return min(d, distance * model_per_object.x) * length(mat3(world_from_model) * s);
}
#endif

void main() {
    for (int k = 0; k < LIGHTS; ++k) {
        thickness[k] = 0.0;
        for (int i = 0; i < SLOTS; ++i)
            thickness[k] += dot(c[i], y[k * SLOTS + i]);
#ifdef POINT_LIGHTS
        if (near[k].w == 1.0)
            thickness[k] = toward_near(near[k].xyz);
#endif
    }
}
