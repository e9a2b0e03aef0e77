// Phong and Green need nothing from a vertex but its place.

void main() {
    place_vertex();
}
