// The stretches inside the material between the light and the point, over the peeled surfaces.

float thickness(int i, vec3 N, vec3 place) {
    Seen seen = seen_by(i, N, place);
    float end = seen.depth - seen.bias;
    // A first surface that the light leaves through: it stands in the material.
    int enclosing = stored_depth(i, seen, 0) < 0.0 ? 1 : 0;
    float sum = 0.0, before = 0.0;
    for (int behind = 0; behind < LAYERS; ++behind) {
        float stored = stored_depth(i, seen, behind);
        if (stored == 0.0 || abs(stored) >= end)
            break;
        if (enclosing > 0)
            sum += abs(stored) - before;
        enclosing += stored > 0.0 ? 1 : -1;
        before = abs(stored);
    }
    return sum + (enclosing > 0 ? max(end - before, 0.0) : 0.0);
}
