// Running lines, and what is said of them.
#include "view/script.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "text/diagnostics.h"
#include "text/fault_lines.h"
#include "view/commands.h"

namespace nephrite::view {
namespace {

/// Opens a line that says what is wrong with a command's own words.
const std::string ofCommand = fmt::format("{}: error: ", commandPlace);

/// What a line of a fault says, less that it is an error: the line it is put into says so.
std::string inWords(std::string line) {
    constexpr std::string_view mark = ": error: ";
    if (line.starts_with(ofCommand)) return line.substr(ofCommand.size());
    if (const std::size_t at = line.find(mark); at != std::string::npos) line.replace(at, mark.size(), ": ");
    return line;
}

}  // namespace

Script::Script(std::filesystem::path file, std::function<void()> onLine)
    : file_(std::move(file)), input_(file_, std::move(onLine)) {}

void Script::runNext(Viewer& viewer) {
    const std::string text = input_.next().value();
    ++line_;
    try {
        runCommand(viewer, text);
    } catch (const std::exception& error) {
        if (!isFile()) throw;
        std::vector<Diagnostic> faults;
        for (std::string& line : linesOf(error))
            faults.push_back({{file_.string(), line_, 1}, inWords(std::move(line))});
        throw InputError(std::move(faults));
    }
}

std::vector<std::string> Script::placed(std::vector<std::string> lines) const {
    if (!isFile()) return lines;
    for (std::string& line : lines) line = toLine({{file_.string(), line_, 1}, inWords(std::move(line))});
    return lines;
}

void Script::answer(const std::string& text) {
    if (text.find("error: ") != std::string::npos) ++failures_;
    fmt::print("{}\n", text);
    std::fflush(stdout);
}

void Script::requireAllDone() const {
    if (!isFile() || failures_ == 0) return;
    throw InputError({file_.string()}, fmt::format("{} of {} lines failed", failures_, line_));
}

}  // namespace nephrite::view
