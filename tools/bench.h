// The sub-verbs of `nephrite bench`, a file each.
#pragma once

#include "verbs.h"

namespace nephrite::tools {

void addBenchCompile(CLI::App& bench, Action& action);
void addBenchStress(CLI::App& bench, Action& action);
void addBenchPareto(CLI::App& bench, Action& action);
void addBenchCompareTimings(CLI::App& bench, Action& action);

}  // namespace nephrite::tools
