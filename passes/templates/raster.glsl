// What NAME draws, in a sentence. Called once for each covered fragment of every object.
void fragment(Fragment f) {
    store(result, f.pixel, vec4(params.strength * (0.5 * f.normal + 0.5), 1.0));
}
