// Phong's model and the attenuation laws, once for all methods.  Linear light, lengths in mm.
// The symbols are the paper's: I_a ambient and I_p light intensity (perpendicular irradiance over
// pi), k the coefficients of the four terms, N normal, L toward the light, V toward the eye.

layout(std140, binding = 0) uniform Shading {
    mat4 clip_from_object;
    mat4 world_from_object;
    mat4 world_from_object_normal; // inverse transpose
    vec4 eye;
    vec4 to_light;
    vec4 I_a;
    vec4 I_p;
    vec4 k_am;
    vec4 k_di;
    vec4 k_sp; // w: exponent q
    vec4 k_sc;
    vec4 sigma_tr;
    vec4 law; // x: 1 for the paper's; y: 1/D_n; z: longest possible chord
};

// A zero vector stays zero instead of becoming NaN.
vec3 unit(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
}

vec3 phong(vec3 N, vec3 V) {
    vec3 L = to_light.xyz;
    float cosine = dot(N, L);
    vec3 colour = I_a.rgb * k_am.rgb + I_p.rgb * k_di.rgb * max(cosine, 0.0);
    if (cosine > 0.0) {
        vec3 R = 2.0 * cosine * N - L;
        colour += I_p.rgb * k_sp.rgb * pow(max(dot(R, V), 0.0), k_sp.w);
    }
    return colour;
}

// What is left of the light after a thickness d, per channel.  Reconstructed thickness may leave
// the possible range: below 0 it would brighten past k_sc.
vec3 attenuation(float d) {
    d = clamp(d, 0.0, law.z);
    if (law.x == 1.0)
        return vec3(1.0 - min(d * law.y, 1.0));
    return exp(-sigma_tr.rgb * d);
}

// The paper's fourth term.
vec3 scatter(float d) {
    return I_p.rgb * k_sc.rgb * attenuation(d);
}
