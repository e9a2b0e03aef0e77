// The baked thickness.

layout(location = 2) in float d; // mm
out float thickness;

void main() {
    place_vertex();
    thickness = d;
}
