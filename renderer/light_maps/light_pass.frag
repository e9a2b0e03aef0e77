// Depth of a surface, positive where the light enters the material and negative where it leaves.

layout(binding = 0) uniform sampler2DArray layers;

in vec3 world_position;
out float signed_depth;

void main() {
    // 0 would be nothing.
    float depth = max(light_depth(pass.light, world_position), 1e-6);
    if (pass.peeling == 1) {
        float before = abs(texelFetch(layers, ivec3(gl_FragCoord.xy, pass.layer - 1), 0).r);
        if (before == 0.0 || depth <= before)
            discard;
    }
#ifndef LINEAR
    gl_FragDepth = depth / view[pass.light].extent.x;
#endif
    signed_depth = gl_FrontFacing == (pass.mirrored == 0) ? depth : -depth;
}
