// What NAME computes, in a sentence. Called once for each texel of `result`.
void pixel(ivec2 p) {
    vec4 value = load(source, p);
    store(result, p, vec4(params.strength * value.rgb, value.a));
}
