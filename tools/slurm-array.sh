#!/bin/sh
# Splits long work over a Slurm job array, one job a part, and puts the parts together when all are done:
#     tools/slurm-array.sh reference PARTS OUTPUT.exr SCENE [OPTIONS OF nephrite reference]...
#     tools/slurm-array.sh sweep PARTS FOLDER FILE [OPTIONS OF nephrite sweep]...
# With --stderr F.exr the standard errors of a reference are written a part a file and merged, too.
# Environment: NEPHRITE (the program), SBATCH_* (as sbatch reads them). Give the same line again to continue.
set -eu

case "${1-}" in reference | sweep) ;; *) set -- ;; esac
if [ $# -lt 4 ]; then
    echo "usage: $0 reference PARTS OUTPUT.exr SCENE [OPTION]..." >&2
    echo "       $0 sweep PARTS FOLDER FILE [OPTION]..." >&2
    exit 2
fi
verb=$1
parts=$2
output=$3
shift 3

# Every job must write files of its own: --stderr becomes ERRORS, and what a job is given by this script is refused.
errors=
before=
for argument in "$@"; do
    shift
    case "$before$argument" in
        --stderr=*) errors=${argument#*=} before= ;;
        --stderr) before=--stderr= ;;
        -o* | --output* | --part* | --threads*)
            echo "$0: $argument is given by this script" >&2
            exit 2
            ;;
        *) set -- "$@" "$argument" ;;
    esac
done

root=$(cd "$(dirname "$0")/.." && pwd)
export NEPHRITE="${NEPHRITE:-$root/build/release/nephrite}"
export VERB="$verb" PARTS="$parts" OUTPUT="$output" STEM="${output%.exr}" ERRORS="${errors%.exr}"
case $verb in
    reference) folder=$(dirname "$output") ;;
    sweep) folder=$output ;;
esac
mkdir -p "$folder"

# Arguments reach the jobs as theirs, so names with blanks stay whole.
array=$(sbatch --parsable --array="1-$parts" --job-name="$verb" --output="$folder/$verb-%a.log" \
    /dev/stdin "$@" <<'JOB'
#!/bin/sh
part=$SLURM_ARRAY_TASK_ID
if [ "$VERB" = sweep ]; then exec "$NEPHRITE" sweep "$@" --part "$part/$PARTS" -o "$OUTPUT"; fi
if [ -n "$ERRORS" ]; then set -- "$@" --stderr "$ERRORS.part-$part.exr"; fi
exec "$NEPHRITE" reference "$@" --threads "${SLURM_CPUS_PER_TASK:-1}" --part "$part/$PARTS" -o "$STEM.part-$part.exr"
JOB
)
sbatch --parsable --dependency="afterok:${array%%;*}" --job-name="$verb-merge" \
    --output="$folder/$verb-merge.log" /dev/stdin "$@" <<'JOB'
#!/bin/sh
set -eu
# All runs of a sweep are done: what is left of it are its tables.
if [ "$VERB" = sweep ]; then exec "$NEPHRITE" sweep "$@" -o "$OUTPUT"; fi
for stem in "$STEM" "$ERRORS"; do
    [ -n "$stem" ] || continue
    set --
    for part in $(seq "$PARTS"); do set -- "$@" "$stem.part-$part.exr"; done
    "$NEPHRITE" merge "$@" -o "$stem.exr"
done
JOB
