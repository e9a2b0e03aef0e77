// Radiance at a vertex from its cluster's representatives, which the light has met already.
// [Sloan2003]  One input row holds the cluster's number and VECTORS weights, SLOTS inputs of four.

layout(location = 2) in vec4 row[SLOTS];
layout(std140, binding = 1) uniform Representatives {
    vec4 representative[CLUSTERS * (VECTORS + 1)]; // of each cluster the mean, then the vectors
};
out vec3 radiance;

void main() {
    int at = int(row[0].x) * (VECTORS + 1);
    vec3 sum = representative[at].rgb;
    for (int j = 1; j <= VECTORS; ++j)
        sum += row[j / 4][j % 4] * representative[at + j].rgb;
    radiance = max(sum, vec3(0.0)); // a light of few bands is negative in places
}
