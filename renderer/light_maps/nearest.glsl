// Depth behind the first surface the light meets.

float thickness(int i, vec3 N, vec3 place) {
    Seen seen = seen_by(i, N, place);
    float stored = stored_depth(i, seen, 0);
    return stored == 0.0 ? 0.0 : max(seen.depth - abs(stored) - seen.bias, 0.0);
}
