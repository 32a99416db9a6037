// What NAME computes, in a sentence. Called on a grid of 8 x 8 groups that covers `result`; shared memory is at hand.
void compute(uvec3 id) {
    ivec2 p = ivec2(id.xy);
    if (any(greaterThanEqual(p, extent(result)))) return;
    vec4 value = load(source, p);
    store(result, p, vec4(params.strength * value.rgb, value.a));
}
