#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test, less those labelled `long` (`ctest -L long` runs
# them). Arguments go to ctest, for example `tools/test.sh -R Exr`.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

tools/setup.sh
cmake --preset release
cmake --build --preset release
ctest --test-dir build/release --output-on-failure --no-tests=error -j 2 -LE '^long$' "$@"

# Other versions of clang-format lay out some lines differently.
if command -v clang-format >/dev/null && [[ $(clang-format --version) == *"version 14."* ]]; then
    find framework passes tests tools \( -name '*.cpp' -o -name '*.h' \) -print0 |
        xargs -0 --no-run-if-empty clang-format --dry-run --Werror
    echo "test: the sources are formatted as .clang-format says"
fi
