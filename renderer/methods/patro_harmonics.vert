// Smoothed irradiance of every light at a vertex: sum e_lm y_lm(L), L in the model's axes.

layout(location = 2) in vec3 e[9]; // red, green and blue of each coefficient

out vec3 irradiance[LIGHTS];

void main() {
    place_vertex();
    for (int i = 0; i < LIGHTS; ++i) {
        // The inverse of the placement: what its inverse transpose does to N, undone for L.
        vec3 L = transpose(mat3(world_from_object_normal)) * toward_light(i, world_position);
        vec4 y[SLOTS];
        evaluate(unit(L), y);
        irradiance[i] = vec3(0.0);
        for (int k = 0; k < 4; ++k)
            irradiance[i] += e[k] * y[0][k];
        for (int k = 0; k < 5; ++k) // band 2
            irradiance[i] += e[4 + k] * y[1 + k / 4][k % 4];
    }
}
