// One axis of a Gaussian over depths that are there; what is empty has no weight.  ROWS: the first
// pass, from a map to sums of depths and of weights; else the second, from these to depths.

layout(std140, binding = 0) uniform Gaussian {
    float deviation; // texels
    int radius;      // texels
};

#ifdef ROWS
layout(binding = 0) uniform sampler2DArray map;
out vec4 sums; // depths, weights

vec2 at(int offset) {
    ivec2 place = ivec2(gl_FragCoord.xy) + ivec2(offset, 0);
    if (place.x < 0 || place.x >= textureSize(map, 0).x)
        return vec2(0.0);
    float depth = abs(texelFetch(map, ivec3(place, 0), 0).r);
    return vec2(depth, depth == 0.0 ? 0.0 : 1.0);
}
#else
layout(binding = 0) uniform sampler2D rows;
out float depth;

vec2 at(int offset) {
    ivec2 place = ivec2(gl_FragCoord.xy) + ivec2(0, offset);
    if (place.y < 0 || place.y >= textureSize(rows, 0).y)
        return vec2(0.0);
    return texelFetch(rows, place, 0).rg;
}
#endif

void main() {
    vec2 sum = at(0);
    for (int offset = 1; offset <= radius; ++offset) {
        float way = float(offset) / deviation;
        sum += exp(-0.5 * way * way) * (at(offset) + at(-offset));
    }
#ifdef ROWS
    sums = vec4(sum, 0.0, 1.0);
#else
    depth = sum.y == 0.0 ? 0.0 : sum.x / sum.y;
#endif
}
