// Real spherical harmonics of a unit vector by normalised recurrences, in the order of SHSS's shader
// inputs: bands 0 and 1 in the first, every later band from a new one on.  BANDS, SLOTS: how many.
// The same recurrences as renderer/harmonics/basis.cpp, which is where their source stands.

void evaluate(vec3 s, out vec4 slots[SLOTS]) {
    for (int i = 0; i < SLOTS; ++i)
        slots[i] = vec4(0.0);
    float c = 1.0, t = 0.0;      // (x + iy)^m
    float p_mm = 0.28209479177;  // sqrt(1/4pi)
    for (int m = 0; m < BANDS; ++m) {
        if (m > 0) {
            p_mm *= sqrt((2.0 * m + 1.0) / (2.0 * m));
            float before = c;
            c = s.x * before - s.y * t;
            t = s.x * t + s.y * before;
        }
        float twice = m == 0 ? 1.0 : 1.41421356237;
        float p_before = 0.0, p = p_mm;
        for (int l = m; l < BANDS; ++l) {
            if (l > m) {
                float a = sqrt((4.0 * l * l - 1.0) / float(l * l - m * m));
                float b = sqrt(float((l - 1) * (l - 1) - m * m) / (4.0 * (l - 1) * (l - 1) - 1.0));
                float next = a * (s.z * p - b * p_before);
                p_before = p;
                p = next;
            }
            // Inputs before band l: 1 for bands 0 and 1, (2l + 4) / 4 for each one since.
            int first = 0;
            for (int k = 2; k < l; ++k)
                first += (2 * k + 4) / 4;
            first = l < 2 ? 0 : 4 * (1 + first);
            int centre = l < 2 ? l * (l + 1) : first + l;
            slots[(centre + m) / 4][(centre + m) % 4] = twice * p * c;
            if (m > 0)
                slots[(centre - m) / 4][(centre - m) % 4] = twice * p * t;
        }
    }
}
