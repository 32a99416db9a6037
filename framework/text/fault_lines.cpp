// From exceptions to lines.
#include "text/fault_lines.h"

#include <new>

#include "text/diagnostics.h"

namespace nephrite {

std::vector<std::string> linesOf(const std::exception& error) {
    if (const auto* input = dynamic_cast<const InputError*>(&error)) {
        std::vector<std::string> lines;
        for (const Diagnostic& fault : input->faults()) lines.push_back(toLine(fault));
        return lines;
    }
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return {"nephrite: error: out of memory"};
    const std::string message = error.what();
    return {message.find(": error: ") == std::string::npos ? "nephrite: error: " + message : message};
}

}  // namespace nephrite
