// Depth behind the blurred first surface.  It is read smoothly: there are no steps to hide with a
// bias.

float thickness(int i, vec3 N, vec3 place) {
    Seen seen = seen_by(i, N, place);
    float stored = texture(light_map[i], vec3(seen.place, 0.0)).r;
    return stored == 0.0 ? 0.0 : max(seen.depth - stored, 0.0);
}
