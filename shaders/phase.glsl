// Phase functions: how scattering spreads light over directions, 1/sr.
#ifndef PHASE_GLSL
#define PHASE_GLSL

const float pi = 3.14159265358979;

/// Eq. 9 as printed: Schlick's phase function (Blasi, Le Saec and Schlick 1993) with the sign of the cosine flipped and
/// g in the place of k. `cosine` is that of the angle between the direction of travel before and after.
/// |g| is limited to 0.999, because at 1 the function is 0/0.
float phaseLiteral(float cosine, float g) {
    float limited = clamp(g, -0.999, 0.999);
    float denominator = 1.0 + limited * cosine;
    return (1.0 - limited * limited) / (4.0 * pi * denominator * denominator);
}

/// Henyey and Greenstein (1941), (1 - g^2)/(4 pi (1 + g^2 - 2 g c)^1.5), c the cosine of the angle between the directions of
/// travel before and after. 1 + g^2 - 2 g c is written (1 - g)^2 + 2 g (1 - c), which keeps its digits at the peak; |g| is
/// limited to 0.999, because at 1 the function is 0/0.
float phaseHenyeyGreenstein(float cosine, float g) {
    float limited = clamp(g, -0.999, 0.999);
    float side = limited < 0.0 ? -1.0 : 1.0;
    float spread = 1.0 - abs(limited);
    float base = spread * spread + 2.0 * abs(limited) * max(0.0, 1.0 - side * cosine);
    return (1.0 - limited * limited) / (4.0 * pi * base * sqrt(base));
}

#endif
