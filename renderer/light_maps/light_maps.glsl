// Reading the maps of light_maps.h in a shader that draws the surface.  LAYERS surfaces behind each
// other to a face.

layout(binding = 0) uniform sampler2DArray light_map[LIGHTS];

// A point as the light sees it.
struct Seen {
    vec2 place;  // in the map, 0..1
    int layer;   // first of its face
    float depth; // mm
    float bias;  // mm
};

// A point of a surface lies up to a texel times its slope behind the depth stored for its texel:
// that much is the bias, for slopes of up to 4.  Depths themselves are right to some roundings.
Seen seen_by(int i, vec3 N, vec3 place) {
    int face = facing(i, place);
    vec4 clip = clip_from_world(i, face, place);
    float depth = light_depth(i, place);
    float width = 2.0 * (is_near(i) ? depth : view[i].origin.w);
    float texel = width / float(textureSize(light_map[i], 0).x);
    float cosine = abs(dot(N, toward_light(i, place)));
    float tangent = sqrt(max(1.0 - cosine * cosine, 0.0)) / max(cosine, 1e-6);
    return Seen(clip.xy / max(clip.w, 1e-30) * 0.5 + 0.5, face * LAYERS, depth,
                texel * min(tangent, 4.0) + 3e-7 * view[i].extent.x);
}

// Signed depth (light_pass.frag) of the surface that the texel sees, 0 where there is none.
float stored_depth(int i, Seen seen, int behind) {
    ivec2 size = textureSize(light_map[i], 0).xy;
    ivec2 texel = clamp(ivec2(floor(seen.place * vec2(size))), ivec2(0), size - 1);
    return texelFetch(light_map[i], ivec3(texel, seen.layer + behind), 0).r;
}
