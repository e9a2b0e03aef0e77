// Phong's model and the attenuation laws, once for all methods.  Linear light, lengths in mm.
// The symbols are the paper's: I_a ambient and I_p light intensity (perpendicular irradiance over
// pi), k the coefficients of the four terms, N normal, L toward the light, V toward the eye.
// LIGHTS is the number of lights; POINT_LIGHTS is defined when some of them are near.

layout(std140, binding = 0) uniform Shading {
    mat4 clip_from_object;
    mat4 world_from_object;
    mat4 world_from_object_normal; // inverse transpose
    vec4 eye;
    vec4 I_a;
    vec4 k_am;
    vec4 k_di;
    vec4 k_sp; // w: exponent q
    vec4 k_sc;
    vec4 sigma_tr;
    vec4 law; // x: 1 for the paper's; y: 1/D_n; z: longest possible chord
    vec4 light[8];     // xyz toward a far light, w 0; xyz where a near one stands, w 1
    vec4 intensity[8]; // rgb; w: squared distance at which a near light has it
};

// A zero vector stays zero instead of becoming NaN.
vec3 unit(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
}

vec3 toward_light(int i, vec3 place) {
#ifdef POINT_LIGHTS
    return light[i].w == 0.0 ? light[i].xyz : unit(light[i].xyz - place);
#else
    return light[i].xyz;
#endif
}

vec3 I_p(int i, vec3 place) {
#ifdef POINT_LIGHTS
    vec3 way = light[i].xyz - place;
    if (light[i].w == 1.0)
        return intensity[i].rgb * (intensity[i].w / max(dot(way, way), 1e-30));
#endif
    return intensity[i].rgb;
}

vec3 ambient() {
    return I_a.rgb * k_am.rgb;
}

vec3 highlight(int i, vec3 N, vec3 L, vec3 V, vec3 place) {
    float cosine = dot(N, L);
    if (cosine <= 0.0)
        return vec3(0.0);
    vec3 R = 2.0 * cosine * N - L;
    return I_p(i, place) * k_sp.rgb * pow(max(dot(R, V), 0.0), k_sp.w);
}

vec3 phong(vec3 N, vec3 place) {
    vec3 V = unit(eye.xyz - place);
    vec3 colour = ambient();
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 L = toward_light(i, place);
        colour += I_p(i, place) * k_di.rgb * max(dot(N, L), 0.0) + highlight(i, N, L, V, place);
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

// The paper's fourth term, of one light.
vec3 scatter(int i, float d, vec3 place) {
    return I_p(i, place) * k_sc.rgb * attenuation(d);
}
