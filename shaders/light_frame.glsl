// Finding many points in the view of one light: what the scene's lightTexelOf does, with the light read only once.
// A march asks for every step, and reads of storage buffers are dear where they are served lane by lane.
#ifndef LIGHT_FRAME_GLSL
#define LIGHT_FRAME_GLSL

struct LightFrame {
    uint light;
    vec3 position;       // mm
    bool isCube;         // six views; which one depends on the point, so that only the scene's own look-up will do
    uint view;           // the only view of another light, and its frame
    vec3 right;
    vec3 up;
    vec3 forward;
    vec2 tanHalfFov;
};

LightFrame lightFrameOf(uint light) {
    uint view = lights[light].firstView;
    return LightFrame(light, lights[light].position, lights[light].viewCount > 1u, view, lightViews[view].right,
                      lightViews[view].up, lightViews[view].forward,
                      vec2(lightViews[view].tanHalfFovX, lightViews[view].tanHalfFovY));
}

/// Which view of the light sees a world position (mm), and where in it (0..1, y down).
LightTexel texelIn(LightFrame frame, vec3 point) {
    if (frame.isCube) return lightTexelOf(frame.light, point);
    vec3 fromLight = point - frame.position;
    float depth = dot(fromLight, frame.forward);
    vec2 slope = vec2(dot(fromLight, frame.right), -dot(fromLight, frame.up)) / depth;
    vec2 uv = 0.5 + 0.5 * slope / frame.tanHalfFov;
    bool inside = depth > 0.0 && all(greaterThanEqual(uv, vec2(0.0))) && all(lessThanEqual(uv, vec2(1.0)));
    return LightTexel(inside, frame.view, inside ? uv : vec2(0.5));
}

#endif
