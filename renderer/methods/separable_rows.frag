// The first axis, over the whole picture.

out vec4 body;

void main() {
    body = blurred(ivec2(gl_FragCoord.xy), ivec2(1, 0));
}
