// Finding many points in the view of one light: what the scene's lightTexelOf does, with the light read only once.
// A march asks for every step, and reads of storage buffers are dear where they are served lane by lane.
#ifndef LIGHT_FRAME_GLSL
#define LIGHT_FRAME_GLSL

struct LightFrame {
    uint light;
    vec3 position;       // mm
    bool isCube;         // six views; which one depends on the point, so that only the scene's own look-up will do
    uint view;           // the only view of another light, and the rows of its matrix
    vec4 across;
    vec4 down;
    vec4 depth;
};

LightFrame lightFrameOf(uint light) {
    uint view = lights[light].firstView;
    mat4 rows = transpose(lightViews[view].viewProjection);
    return LightFrame(light, lights[light].position, lights[light].viewCount > 1u, view, rows[0], rows[1], rows[3]);
}

/// Which view of the light sees a world position (mm), and where in it (0..1, y down).
LightTexel texelIn(LightFrame frame, vec3 point) {
    if (frame.isCube) return lightTexelOf(frame.light, point);
    vec4 place = vec4(point, 1.0);
    float depth = dot(frame.depth, place);
    vec2 uv = 0.5 + 0.5 * vec2(dot(frame.across, place), dot(frame.down, place)) / depth;
    bool inside = depth > 0.0 && all(greaterThanEqual(uv, vec2(0.0))) && all(lessThanEqual(uv, vec2(1.0)));
    return LightTexel(inside, frame.view, inside ? uv : vec2(0.5));
}

#endif
