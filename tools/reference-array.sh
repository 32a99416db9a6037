#!/bin/sh
# Renders a reference as a Slurm job array, one job a part, and merges the parts when all are done:
#     tools/reference-array.sh PARTS OUTPUT.exr SCENE [OPTIONS OF nephrite reference]...
# With --stderr F.exr the standard errors are written a part a file and merged, too.
# Environment: NEPHRITE (the program), SBATCH_* (as sbatch reads them). Give the same line again to continue.
set -eu

if [ $# -lt 3 ]; then
    echo "usage: $0 PARTS OUTPUT.exr SCENE [OPTION]..." >&2
    exit 2
fi
parts=$1
output=$2
shift 2

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
export PARTS="$parts" STEM="${output%.exr}" ERRORS="${errors%.exr}"
folder=$(dirname "$output")
mkdir -p "$folder"

# Arguments reach the jobs as theirs, so names with blanks stay whole.
array=$(sbatch --parsable --array="1-$parts" --job-name=reference --output="$folder/reference-%a.log" \
    /dev/stdin "$@" <<'JOB'
#!/bin/sh
part=$SLURM_ARRAY_TASK_ID
if [ -n "$ERRORS" ]; then set -- "$@" --stderr "$ERRORS.part-$part.exr"; fi
exec "$NEPHRITE" reference "$@" --threads "${SLURM_CPUS_PER_TASK:-1}" --part "$part/$PARTS" -o "$STEM.part-$part.exr"
JOB
)
sbatch --parsable --dependency="afterok:${array%%;*}" --job-name=reference-merge \
    --output="$folder/reference-merge.log" /dev/stdin <<'JOB'
#!/bin/sh
set -eu
for stem in "$STEM" "$ERRORS"; do
    [ -n "$stem" ] || continue
    set --
    for part in $(seq "$PARTS"); do set -- "$@" "$stem.part-$part.exr"; done
    "$NEPHRITE" merge "$@" -o "$stem.exr"
done
JOB
