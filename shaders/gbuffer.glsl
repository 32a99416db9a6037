// What a view sees: the nearest surface's position, normal, texture coordinates and material.
void fragment(Fragment f) {
    store(position, f.pixel, vec4(f.position, 1.0));
    store(normal, f.pixel, vec4(f.normal, 1.0));
    store(surface, f.pixel, vec4(f.uv, float(f.material + 1u), 1.0));
}
