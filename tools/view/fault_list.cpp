// Catching, printing and keeping faults.
#include "view/fault_list.h"

#include <fmt/format.h>

#include <cstdio>

#include "text/fault_lines.h"

namespace nephrite::view {

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
