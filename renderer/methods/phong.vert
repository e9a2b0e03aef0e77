// For the methods that need nothing from a vertex but its place and normal.

void main() {
    place_vertex();
}
