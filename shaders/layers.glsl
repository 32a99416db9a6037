// Paths through a stack of layers (Eqs. 7, 10 and 11).
#ifndef LAYERS_GLSL
#define LAYERS_GLSL

/// The part of a path that lies in its next layer. `rest` is the length still to be shared out (mm) and loses that part;
/// `thickness` is the layer's (mm, 10^30 for infinite), `cosine` > 0 the path's cosine to the normal. Called once for each
/// layer but the last, with the rest left to the last, this is Eq. 11 with the clamp that keeps it from going negative:
/// clamp(length - sum of the layers above, 0, thickness/cosine).
float lengthInLayer(inout float rest, float thickness, float cosine) {
    float part = min(rest, thickness / cosine);
    rest -= part;
    return part;
}

/// The thickness of layer k, mm, out of the texel that holds layers 4*floor(k/4) to 4*floor(k/4) + 3 (Eq. 1).
float thicknessOf(vec4 fourLayers, int k) {
    return fourLayers[k & 3];
}

#endif
