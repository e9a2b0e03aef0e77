// Thickness toward the light from spherical harmonics, per vertex.  [SHSS, eq. 2]
// SLOTS is the number of inputs the used bands fill: bands begin a new input each, the rest of a
// band's last input meets zeros in y.

layout(location = 2) in vec4 c[SLOTS];

layout(std140, binding = 1) uniform Light {
    vec4 y[SLOTS]; // basis functions toward the light, over the model's stretch: mm
};

out float thickness;

void main() {
    place_vertex();
    thickness = 0.0;
    for (int i = 0; i < SLOTS; ++i)
        thickness += dot(c[i], y[i]);
}
