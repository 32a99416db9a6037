// tools/slurm-array.sh with an `sbatch` that runs each job at once.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "program.h"

namespace nephrite::tools::test {

/// Runs `SCRIPT ARGUMENTS`, a script of the source tree's tools/ unless it is a whole path, in the folder;
/// what std::system returns. Its standard error goes to the file `errors`.
inline int submit(const Workplace& place, const std::filesystem::path& script, const std::string& arguments) {
    const auto sbatch = place.write("bin/sbatch", R"sh(#!/bin/sh
jobs=1
while [ "$1" != /dev/stdin ]; do
    case "$1" in --array=1-*) jobs=${1#--array=1-} ;; esac
    shift
done
shift
cat > job.sh
for job in $(seq "$jobs"); do SLURM_ARRAY_TASK_ID=$job sh job.sh "$@" || exit 1; done
echo 7
)sh");
    std::filesystem::permissions(sbatch, std::filesystem::perms::owner_all);
    const std::string command = "cd '" + place.path().string() +
                                "' && PATH=\"$PWD/bin:$PATH\" NEPHRITE='" NEPHRITE_PROGRAM "' '" +
                                (std::filesystem::path(NEPHRITE_SOURCE_DIR) / "tools" / script).string() +
                                "' " + arguments + " > /dev/null 2> errors";
    return std::system(command.c_str());
}

}  // namespace nephrite::tools::test
