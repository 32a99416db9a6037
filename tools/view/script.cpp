// Running lines, and what is said of them.
#include "view/script.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "text/diagnostics.h"
#include "view/commands.h"

namespace nephrite::view {
namespace {

/// A place as it stands in front of a fault.
std::string placeText(const SourceLocation& where) {
    return where.line == 0 ? where.file : fmt::format("{}:{}:{}", where.file, where.line, where.column);
}

/// A fault at a line of a script. Where it has a place of its own this stays in its words.
Diagnostic placed(const Diagnostic& fault, const std::string& script, std::uint32_t line) {
    const bool isOfCommand = fault.where.file == commandPlace;
    return {{script, line, 1},
            isOfCommand ? fault.message : fmt::format("{}: {}", placeText(fault.where), fault.message)};
}

}  // namespace

Script::Script(std::filesystem::path file, std::function<void()> onLine)
    : file_(std::move(file)), input_(file_, std::move(onLine)) {}

void Script::runNext(Viewer& viewer) {
    const std::string text = input_.next().value();
    ++line_;
    try {
        runCommand(viewer, text);
    } catch (const InputError& error) {
        if (!isFile()) throw;
        std::vector<Diagnostic> faults;
        for (const Diagnostic& fault : error.faults()) faults.push_back(placed(fault, file_.string(), line_));
        throw InputError(std::move(faults));
    }
}

void Script::answer(const std::string& text) {
    if (text != "ok") ++failures_;
    fmt::print("{}\n", text);
    std::fflush(stdout);
}

void Script::requireAllDone() const {
    if (!isFile() || failures_ == 0) return;
    throw InputError({file_.string()}, fmt::format("{} of {} lines failed", failures_, line_));
}

}  // namespace nephrite::view
