// Eq. 3: the weighted sum of the five terms. A term of the output's size is read texel by texel, another size is filtered.
void pixel(ivec2 p) {
    ivec2 size = extent(color);
    vec2 uv = (vec2(p) + 0.5) / vec2(size);
    vec3 sum = params.weights[0] * (extent(diffuse) == size ? load(diffuse, p) : sample(diffuse, uv)).rgb;
    sum += params.weights[1] * (extent(specular) == size ? load(specular, p) : sample(specular, uv)).rgb;
    sum += params.weights[2] * (extent(refraction) == size ? load(refraction, p) : sample(refraction, uv)).rgb;
    sum += params.weights[3] * (extent(single) == size ? load(single, p) : sample(single, uv)).rgb;
    sum += params.weights[4] * (extent(multiple) == size ? load(multiple, p) : sample(multiple, uv)).rgb;
    float coverage = (extent(position) == size ? load(position, p) : sample(position, uv)).w;
    store(color, p, vec4(sum, coverage));
}
