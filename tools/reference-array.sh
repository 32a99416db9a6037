#!/bin/sh
# Renders a reference as a Slurm job array, one job a part, and merges the parts when all are done:
#     tools/reference-array.sh PARTS OUTPUT.exr SCENE [OPTIONS OF nephrite reference]...
# Environment: NEPHRITE (the program), SBATCH_* (as sbatch reads them). Give the same line again to continue.
set -eu

if [ $# -lt 3 ]; then
    echo "usage: $0 PARTS OUTPUT.exr SCENE [OPTION]..." >&2
    exit 2
fi
parts=$1
output=$2
shift 2

root=$(cd "$(dirname "$0")/.." && pwd)
export NEPHRITE="${NEPHRITE:-$root/build/release/nephrite}"
export PARTS="$parts" STEM="${output%.exr}"
folder=$(dirname "$output")
mkdir -p "$folder"

# Arguments reach the jobs as theirs, so names with blanks stay whole.
array=$(sbatch --parsable --array="1-$parts" --job-name=reference --output="$folder/reference-%a.log" \
    /dev/stdin "$@" <<'JOB'
#!/bin/sh
exec "$NEPHRITE" reference "$@" --threads "${SLURM_CPUS_PER_TASK:-1}" \
    --part "$SLURM_ARRAY_TASK_ID/$PARTS" -o "$STEM.part-$SLURM_ARRAY_TASK_ID.exr"
JOB
)
sbatch --parsable --dependency="afterok:${array%%;*}" --job-name=reference-merge \
    --output="$folder/reference-merge.log" /dev/stdin <<'JOB'
#!/bin/sh
for part in $(seq "$PARTS"); do set -- "$@" "$STEM.part-$part.exr"; done
exec "$NEPHRITE" merge "$@" -o "$STEM.exr"
JOB
