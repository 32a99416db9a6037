// Any bytes as a graph file, as a pass manifest, as an expression and as a reference to a port: read and
// linked, or refused with an InputError.
#include <cstdint>
#include <cstdlib>

#include "graph/pass_listing.h"
#include "graph/small_library.h"

namespace {

using namespace nephrite;

/// Refusing is right, but every fault must be a line of its own with something in it.
template<class Action>
void refusing(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        if (error.faults().empty()) std::abort();
        for (const Diagnostic& fault : error.faults()) {
            if (fault.message.empty() || toLine(fault).find('\n') != std::string::npos) std::abort();
        }
    }
}

void readAsGraph(const json::Value& value) {
    static const graph::PassLibrary library = graph::tests::smallLibrary();
    const auto linked = graph::link(graph::readGraph(value), library);
    if (linked->declarationOrder.size() != linked->nodes.size()) std::abort();
    if (linked->description.nodes.size() != linked->nodes.size()) std::abort();
    if (linked->modifies.size() != linked->formats.size()) std::abort();
}

void readAsPass(const json::Value& value) {
    Diagnostics diagnostics;
    const graph::PassType type = graph::readPassType(value, "fuzzed", diagnostics);
    diagnostics.throwIfErrors();
    if (graph::describePass(type).empty() || graph::describePassAsJson(type).empty()) std::abort();
}

void readAsExpression(const std::string& text) {
    Diagnostics diagnostics;
    const auto expression = graph::Expression::compile(text, {"fuzzed", 1, 1}, diagnostics);
    if (expression.has_value() == diagnostics.hasErrors()) std::abort();
    if (expression) expression->evaluate([](const graph::ExpressionName&) { return 2.0; });
}

/// What is read must read the same again from the text it has of itself.
void readAsReference(const std::string& text) {
    Diagnostics diagnostics;
    const auto reference = graph::readPortReference(text, {"fuzzed", 1, 1}, diagnostics);
    if (reference.has_value() == diagnostics.hasErrors()) std::abort();
    if (!reference) return;
    const auto again = graph::readPortReference(graph::toText(*reference), {"fuzzed", 1, 1}, diagnostics);
    if (!again || graph::toText(*again) != graph::toText(*reference)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    readAsExpression(text);
    readAsReference(text);
    refusing([&] {
        const json::Value value = json::parse(text, "fuzzed");
        refusing([&] { readAsGraph(value); });
        refusing([&] { readAsPass(value); });
    });
    return 0;
}
