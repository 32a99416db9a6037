// Any bytes as a scene file: read, or refused with an InputError whose every fault is one line.
#include <cstdint>
#include <cstdlib>

#include "scene/scene_description.h"
#include "text/json.h"

namespace {

using namespace nephrite;

void requireWholeFaults(const std::vector<Diagnostic>& faults) {
    if (faults.empty()) std::abort();
    for (const Diagnostic& fault : faults)
        if (fault.message.empty() || toLine(fault).find('\n') != std::string::npos) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const json::Value value = json::parse(std::string(reinterpret_cast<const char*>(data), size), "fuzzed.json");
        Diagnostics diagnostics;
        scene::readScene(value, {}, diagnostics);
        if (diagnostics.hasErrors()) requireWholeFaults(diagnostics.errors());
    } catch (const InputError& error) {
        requireWholeFaults(error.faults());
    }
    return 0;
}
