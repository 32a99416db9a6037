// See small_library.h.
#include "graph/small_library.h"

namespace nephrite::graph::tests {

PassType passFrom(std::string_view manifest, std::string name) {
    Diagnostics diagnostics;
    PassType type = readPassType(json::parse(std::string(manifest), "p.json"), std::move(name), diagnostics);
    diagnostics.throwIfErrors();
    return type;
}

namespace {

void addRepeatedAndModifying(PassLibrary& library) {
    library.add(passFrom(R"({"kind": "pixel", "shader": "s.glsl",
                             "inputs": {"now": {}, "history": {"optional": true}},
                             "outputs": {"color": {"size": {"like": "now"}}}})",
                         "accumulate"));
    library.add(passFrom(R"({"kind": "compute", "shader": "s.glsl", "forEach": "mips",
                             "inputs": {"image": {}}, "outputs": {"pyramid": {"mips": 0}}})",
                         "reduce"));
    library.add(passFrom(R"({"kind": "raster", "shader": "s.glsl",
                             "inputs": {"under": {}, "mask": {"optional": true}},
                             "outputs": {"over": {"modifies": "under"}}})",
                         "draw"));
    library.add(passFrom(R"({"kind": "compute", "shader": "s.glsl",
                             "inputs": {"list": {"buffer": "vec4"}, "image": {"format": "r32u", "optional": true}},
                             "outputs": {"longer": {"modifies": "list"}}})",
                         "append"));
    library.add(passFrom(R"({"kind": "pixel", "shader": "s.glsl", "domain": "surface",
                             "inputs": {"surface": {"optional": true}, "light": {"optional": true}},
                             "outputs": {"color": {}}})",
                         "shade"));
}

}  // namespace

PassLibrary smallLibrary() {
    PassLibrary library;
    library.add(passFrom(R"({"kind": "pixel", "shader": "s.glsl", "outputs": {"color": {}},
                             "parameters": {"level": {"type": "float", "default": 0.5, "range": [0, 1]}}})",
                         "source"));
    library.add(passFrom(R"({"kind": "pixel", "shader": "s.glsl",
                             "inputs": {"a": {}, "b": {"optional": true}},
                             "outputs": {"color": {"size": {"like": "a"}}},
                             "parameters": {"taps": {"type": "uint", "default": 12, "range": [1, 256]},
                                            "offset": {"type": "int", "default": 0},
                                            "weights": {"type": "float[3]", "default": [1, 2, 3]},
                                            "tint": {"type": "vec3", "default": [1, 1, 1], "range": [0, 1]},
                                            "enabled": {"type": "bool", "default": true}}})",
                         "blend"));
    library.add(passFrom(R"({"kind": "compute", "shader": "s.glsl",
                             "outputs": {"count": {"format": "r32u"}, "samples": {"buffer": "vec4", "count": 4}}})",
                         "counters"));
    library.add(passFrom(R"({"kind": "pixel", "shader": "s.glsl",
                             "inputs": {"count": {"format": "r32u", "optional": true},
                                        "samples": {"buffer": "vec4", "optional": true},
                                        "weights": {"buffer": "float", "optional": true}},
                             "outputs": {"color": {}}})",
                         "readers"));
    library.add(passFrom(R"({"kind": "raster", "shader": "s.glsl",
                             "outputs": {"color": {}, "depth": {"format": "d32f"}}})",
                         "depth"));
    addRepeatedAndModifying(library);
    return library;
}

std::shared_ptr<const LinkedGraph> linked(std::string_view text) {
    static const PassLibrary library = smallLibrary();
    return link(readGraph(json::parse(std::string(text), "g.json")), library);
}

Expression expression(const std::string& text) {
    Diagnostics diagnostics;
    const auto result = Expression::compile(text, {"e", 1, 1}, diagnostics);
    diagnostics.throwIfErrors();
    return *result;
}

}  // namespace nephrite::graph::tests
