// The sum of the terms, each a radiance.
void pixel(ivec2 p) {
    vec3 sum = load(diffuse, p).rgb + load(specular, p).rgb + load(single, p).rgb + load(multiple, p).rgb;
    store(color, p, vec4(sum, load(position, p).w));
}
