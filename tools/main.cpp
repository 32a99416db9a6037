// The `nephrite` program: parses the command line, runs a verb, and answers with the exit status of
// docs/quick-start.md: 0 done, 1 it failed while running, 2 what it was given is wrong.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>

#include <algorithm>
#include <cstdio>

#include "text/diagnostics.h"
#include "text/fault_lines.h"
#include "verbs.h"

namespace {

void printLine(std::string_view line) {
    fmt::print(stderr, "{}\n", line);
}

std::vector<std::string> verbNames(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* verb : app.get_subcommands({})) names.push_back(verb->get_name());
    return names;
}

bool hasVerb(const CLI::App& app, std::string_view name) {
    const std::vector<std::string> names = verbNames(app);
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string unknownVerb(const CLI::App& app, const std::string& found) {
    const std::vector<std::string> names = verbNames(app);
    return fmt::format("nephrite: error: expected one of {}, found \"{}\"{}", fmt::join(names, ", "), found,
                       nephrite::suggestion(found, names));
}

int run(const nephrite::tools::Action& action) {
    try {
        action();
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
            throw nephrite::RunError("standard output: error: cannot be written");
        return 0;
    } catch (const std::exception& error) {
        for (const std::string& line : nephrite::linesOf(error)) printLine(line);
        return dynamic_cast<const nephrite::InputError*>(&error) != nullptr ? 2 : 1;
    }
}

/// Large blocks stay with the process when they are freed: who makes one plan after the other would pay for
/// zeroed pages each time.
void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr int largestThreshold = 32 << 20;
    constexpr int never = 1 << 30;
    mallopt(M_MMAP_THRESHOLD, largestThreshold);
    mallopt(M_TRIM_THRESHOLD, never);
#endif
}

}  // namespace

int main(int argc, char** argv) {
    keepFreedMemory();
    CLI::App app{"Nephrite: render graphs as data, for research in rendering"};
    app.require_subcommand(1);
    nephrite::tools::Action action;
    nephrite::tools::addRenderVerb(app, action);
    nephrite::tools::addViewVerb(app, action);
    nephrite::tools::addPlanVerb(app, action);
    nephrite::tools::addCheckVerb(app, action);
    nephrite::tools::addPassesVerb(app, action);
    nephrite::tools::addNewPassVerb(app, action);
    nephrite::tools::addSchemaVerb(app, action);
    nephrite::tools::addBenchVerb(app, action);
    nephrite::tools::addProfileVerb(app, action);
    nephrite::tools::addReferenceVerb(app, action);
    nephrite::tools::addMergeVerb(app, action);
    nephrite::tools::addCompareVerb(app, action);
    nephrite::tools::addSweepVerb(app, action);
    if (argc > 1 && argv[1][0] != '-' && !hasVerb(app, argv[1])) {
        printLine(unknownVerb(app, argv[1]));
        return 2;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        printLine(std::string("nephrite: error: ") + error.what());
        return 2;
    }
    return run(action);
}
