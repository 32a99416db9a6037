// Reflection and refraction at a smooth dielectric boundary.
// eta is the refractive index inside over the one outside; cosines are those of the direction outside.
#ifndef FRESNEL_GLSL
#define FRESNEL_GLSL

/// Cosine of the refracted direction (Snell): 0 at total reflection, which needs eta < 1.
float refractedCosine(float cosine, float eta) {
    return sqrt(max(0.0, 1.0 - (1.0 - cosine * cosine) / (eta * eta)));
}

/// A direction that has entered the medium. `cosine` is -N.T; 0 means that nothing enters.
struct RefractedDirection {
    vec3 direction;
    float cosine;
};

/// T = refract(-V, N, 1/eta) for the unit direction V towards the viewer and the unit normal N.
/// The cosine is taken from Snell's law, not from -N.T, which cancels at grazing angles.
RefractedDirection refractFrom(vec3 toViewer, vec3 normal, float eta) {
    float cosineOutside = dot(normal, toViewer);
    float cosineInside = refractedCosine(cosineOutside, eta);
    vec3 direction = (cosineOutside / eta - cosineInside) * normal - toViewer / eta;
    return RefractedDirection(direction, cosineInside);
}

/// Unpolarised reflectance of a dielectric boundary, Fresnel's equations; 1 at total reflection and at cosine <= 0.
float fresnelReflectance(float cosine, float eta) {
    float inside = refractedCosine(cosine, eta);
    if (cosine <= 0.0 || inside <= 0.0) return 1.0;
    float perpendicular = (cosine - eta * inside) / (cosine + eta * inside);
    float parallel = (eta * cosine - inside) / (eta * cosine + inside);
    return 0.5 * (perpendicular * perpendicular + parallel * parallel);
}

/// 1 - F_dr,ext = 2 int_0^1 F_t(mu) mu dmu: what part of diffuse light from outside enters. With mu = t^2 eight nodes of
/// Gauss and Legendre are good to 1e-5 for eta from 1 to 4. Below 1, reciprocity: eta^2 times that of 1/eta.
float diffuseTransmittance(float eta) {
    const vec4 nodes = vec4(0.183434642495650, 0.525532409916329, 0.796666477413627, 0.960289856497536);
    const vec4 weights = vec4(0.362683783378362, 0.313706645877887, 0.222381034453374, 0.101228536290376);
    float above = max(eta, 1.0 / eta);
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        for (int side = -1; side <= 1; side += 2) {
            float t = 0.5 + 0.5 * float(side) * nodes[i];
            sum += 2.0 * weights[i] * t * t * t * (1.0 - fresnelReflectance(t * t, above));
        }
    }
    return eta >= 1.0 ? sum : sum * eta * eta;
}

/// A = (1 + F_dr)/(1 - F_dr), F_dr the diffuse reflectance seen from inside, by reciprocity 1 - (1 - F_dr,ext)/eta^2.
float boundaryMismatch(float eta) {
    float leaving = diffuseTransmittance(eta) / (eta * eta);
    return (2.0 - leaving) / leaving;
}

/// A = (1 + F_dr)/(1 - F_dr) by Egan and Hilgeman's fit of F_dr (1979), as quoted by Jensen et al. (2001). F_dr is limited to
/// 0.999, because the fit passes 1 near eta = 4. 1 - F_dr is evaluated as such: where it is small a difference would lose it.
float fittedBoundaryMismatch(float eta) {
    float inverse = 1.0 / eta;
    float above = (1.440 * inverse - 0.710) * inverse + 0.332 - 0.0636 * eta;
    float below = 1.4399 - ((0.0636 * inverse - 0.3319) * inverse + 0.7099) * inverse;
    float leaving = max(eta >= 1.0 ? above : below, 0.001);
    return (2.0 - leaving) / leaving;
}

#endif
