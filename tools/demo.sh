#!/usr/bin/env bash
# From a bare Debian or Ubuntu to a picture: installs what is missing, builds, renders the default graph and the
# embedded scene to out/.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

tools/setup.sh
cmake --preset release
cmake --build --preset release --target nephrite

nephrite=build/release/nephrite
graph=graphs/consistent.json
mkdir -p out
echo "demo: rendering $graph"
"$nephrite" render "$graph" -o out/consistent.exr -o out/consistent.png
"$nephrite" render "$graph" --profile --frames 10 --timings out/timings.json
for format in svg dot json txt html; do
    "$nephrite" plan "$graph" -o "out/plan.$format"
done

echo "demo: wrote"
ls -l out/consistent.exr out/consistent.png out/timings.json out/plan.svg out/plan.dot out/plan.json out/plan.txt out/plan.html
