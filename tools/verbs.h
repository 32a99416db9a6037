// The verbs of the program. Each adds its subcommand and options to the command line and, once parsed and
// chosen, sets `action` to what it does; main() runs it and turns exceptions into exit statuses.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace nephrite::tools {

using Action = std::function<void()>;

void addRenderVerb(CLI::App& app, Action& action);
void addViewVerb(CLI::App& app, Action& action);
void addPlanVerb(CLI::App& app, Action& action);
void addCheckVerb(CLI::App& app, Action& action);
void addSchemaVerb(CLI::App& app, Action& action);
void addPassesVerb(CLI::App& app, Action& action);
void addBenchVerb(CLI::App& app, Action& action);
void addProfileVerb(CLI::App& app, Action& action);
void addReferenceVerb(CLI::App& app, Action& action);
void addMergeVerb(CLI::App& app, Action& action);
void addCompareVerb(CLI::App& app, Action& action);
void addNewPassVerb(CLI::App& app, Action& action);

}  // namespace nephrite::tools
