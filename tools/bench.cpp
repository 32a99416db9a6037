// `nephrite bench`: measures Nephrite itself.
#include "bench.h"

namespace nephrite::tools {

void addBenchVerb(CLI::App& app, Action& action) {
    CLI::App* bench = app.add_subcommand("bench", "Measure Nephrite itself");
    bench->require_subcommand(1);
    addBenchCompile(*bench, action);
    addBenchStress(*bench, action);
    addBenchPareto(*bench, action);
    addBenchCompareTimings(*bench, action);
}

}  // namespace nephrite::tools
