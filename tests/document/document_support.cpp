// See document_support.h.
#include "document/document_support.h"

#include "text/json.h"

namespace nephrite::document::tests {
namespace {

void add(graph::PassLibrary& library, std::string name, std::string_view manifest) {
    Diagnostics diagnostics;
    library.add(graph::readPassType(json::parse(std::string(manifest), name + ".json"), name, diagnostics));
    diagnostics.throwIfErrors();
}

}  // namespace

std::shared_ptr<const graph::PassLibrary> smallPasses() {
    auto library = std::make_shared<graph::PassLibrary>();
    add(*library, "source", R"({"kind": "pixel", "shader": "s.glsl", "outputs": {"color": {}}})");
    add(*library, "sum",
        R"({"kind": "pixel", "shader": "s.glsl", "inputs": {"a": {}, "b": {"optional": true}}, "outputs": {"color": {}}})");
    add(*library, "blur",
        R"({"kind": "pixel", "shader": "s.glsl", "inputs": {"image": {}}, "outputs": {"color": {}},
            "parameters": {"radius": {"type": "uint", "default": 2, "range": [0, 64]},
                           "gain": {"type": "float", "default": 1, "range": [0, 10]}}})");
    add(*library, "sharpen",
        R"({"kind": "pixel", "shader": "s.glsl", "inputs": {"image": {}}, "outputs": {"color": {}},
            "parameters": {"radius": {"type": "uint", "default": 1, "range": [0, 8]}}})");
    return library;
}

}  // namespace nephrite::document::tests
