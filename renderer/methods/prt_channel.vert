// One channel's radiance at a vertex: its transfer vector times the light's coefficients.  [Sloan2002]
// SLOTS inputs of four hold the vector, zeros behind its end.

layout(location = 2) in vec4 transfer[SLOTS];
layout(std140, binding = 1) uniform Light {
    vec4 light[SLOTS];
};
out float radiance;

void main() {
    float sum = 0.0;
    for (int i = 0; i < SLOTS; ++i)
        sum += dot(transfer[i], light[i]);
    radiance = max(sum, 0.0); // a light of few bands is negative in places
}
