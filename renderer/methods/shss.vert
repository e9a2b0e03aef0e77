// Thickness toward every light, reconstructed beforehand.

layout(location = 2) in float d[LIGHTS]; // mm
out float thickness[LIGHTS];

void main() {
    place_vertex();
    thickness = d;
}
