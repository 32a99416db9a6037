// Where the ray of a pixel leaves the last surface: the far side of what is seen.
void fragment(Fragment f) {
    store(position, f.pixel, vec4(f.position, 1.0));
}
