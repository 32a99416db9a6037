#!/usr/bin/env bash
# Measures every method of graphs/suites/subsurface.json against its references, and puts the table and the plot into
# docs/results and README.md, unless scenes or methods were left out. Arguments go to `nephrite bench pareto`. References are
# kept in out/results/references and used again; the first run takes about an hour on two cores, later ones a quarter of
# an hour.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

tools/setup.sh
cmake --preset release
cmake --build --preset release --target nephrite

results=out/results
mkdir -p "$results"
build/release/nephrite bench pareto graphs/suites/subsurface.json -o "$results" "$@"

# What is published has every row and every column.
if [[ " $*" == *" --only"* ]] || ! grep -qzE '"leftOut" : \[\s*\]' "$results/pareto.json"; then
    echo "results: $results is new; docs/results and README.md stay as they are, for scenes or methods were left out" >&2
    exit 1
fi
mkdir -p docs/results
cp "$results"/table.md "$results"/pareto.csv "$results"/passes.csv "$results"/pareto.svg docs/results/

# The table stands between two comments of the README.
if [[ $(grep -cE '^<!-- results: (begin|end) -->$' README.md) -ne 2 ]]; then
    echo "results: README.md lacks the comments that the table goes between" >&2
    exit 1
fi
awk '
    FNR == NR { table = table $0 "\n"; next }
    /<!-- results: begin -->/ { print; printf "%s", table; inside = 1; next }
    /<!-- results: end -->/ { inside = 0 }
    !inside { print }
' "$results/table.md" README.md > README.md.new
mv README.md.new README.md
echo "results: docs/results and the table of README.md are new"
