// Catching, printing and keeping faults.
#include "view/fault_list.h"

#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "text/diagnostics.h"

namespace nephrite::view {

std::vector<std::string> linesOf(const std::exception& error) {
    std::vector<std::string> lines;
    if (const auto* input = dynamic_cast<const InputError*>(&error)) {
        for (const Diagnostic& fault : input->faults()) lines.push_back(toLine(fault));
    } else if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
        lines.emplace_back("error: out of memory");
    } else {
        const std::string text = error.what();
        lines.push_back(text.find("error: ") == std::string::npos ? "error: " + text : text);
    }
    return lines;
}

bool FaultList::attempt(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::exception& error) {
        report(linesOf(error));
        return false;
    }
    clear();
    return true;
}

void FaultList::report(std::vector<std::string> lines) {
    for (const std::string& line : lines) fmt::print(stderr, "{}\n", line);
    std::fflush(stderr);
    lines_ = std::move(lines);
}

}  // namespace nephrite::view
