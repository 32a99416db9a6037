// Any image as a picture for the screen.
const vec3 nanColor = vec3(1.0, 0.0, 1.0);
const vec3 infinityColor = vec3(0.0, 1.0, 0.0);

// Keeps the curve defined; negative values and infinity times 0 are 0.
float exposedValue(float value) {
    float exposed = value * params.exposure;
    return exposed > 0.0 ? min(exposed, 1e6) : 0.0;
}

// Khronos PBR Neutral, as framework/image/tone_map.cpp.
vec3 pbrNeutral(vec3 linear) {
    const float startCompression = 0.8 - 0.04;
    const float desaturation = 0.15;
    const float compressible = 1.0 - startCompression;
    float least = min(linear.r, min(linear.g, linear.b));
    vec3 color = linear - (least < 0.08 ? least - 6.25 * least * least : 0.04);
    float peak = max(color.r, max(color.g, color.b));
    if (peak < startCompression) return color;
    float newPeak = 1.0 - compressible * compressible / (peak + compressible - startCompression);
    float toWhite = 1.0 - 1.0 / (desaturation * (peak - newPeak) + 1.0);
    return mix(color * (newPeak / peak), vec3(newPeak), toWhite);
}

vec3 encodeSrgb(vec3 linear) {
    vec3 value = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(value, vec3(1.0 / 2.4)) - 0.055, 12.92 * value, lessThanEqual(value, vec3(0.0031308)));
}

vec3 chosenChannels(vec4 value) {
    if (params.channel == 0u) return value.rgb;
    if (params.channel == 5u) return vec3(dot(value.rgb, vec3(0.2126, 0.7152, 0.0722)));
    return vec3(value[int(params.channel) - 1]);
}

vec3 developed(vec3 color) {
    if (params.curve == 2u) return clamp(0.5 + 0.5 * params.exposure * color, 0.0, 1.0);
    vec3 exposed = vec3(exposedValue(color.r), exposedValue(color.g), exposedValue(color.b));
    return encodeSrgb(params.curve == 1u ? pbrNeutral(exposed) : exposed);
}

void pixel(ivec2 p) {
    int level = int(params.level);
    ivec2 texel = p >> level;
    vec4 value = vec4(loadLayer(image, texel, int(params.layer), level));
    if (params.difference && connected(reference)) value = vec4(abs(value.rgb - load(reference, p).rgb), value.a);
    vec3 color = chosenChannels(value);
    vec3 picture = developed(color);
    if (any(isinf(color))) picture = infinityColor;
    if (any(isnan(color))) picture = nanColor;
    store(shown, p, vec4(picture, 1.0));
}
