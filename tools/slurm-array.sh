#!/bin/sh
# Splits long work over a Slurm job array, one job a part, and puts the parts together when all are done:
#     tools/slurm-array.sh reference PARTS OUTPUT.exr SCENE [OPTIONS OF nephrite reference]...
#     tools/slurm-array.sh sweep PARTS FOLDER FILE [OPTIONS OF nephrite sweep]...
# With --stderr F.exr the standard errors of a reference are written a part a file and merged, too.
# Prints the last job's id. If a part fails, Slurm drops that job. Give the same line again to continue.
# Environment: NEPHRITE (the program), CPUS (of each part; 1), SBATCH_* (as sbatch reads them).
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
case $parts in
    '' | 0* | *[!0-9]*)
        echo "$0: PARTS: expected a whole number from 1, found \"$parts\"" >&2
        exit 2
        ;;
esac

# Slurm reads a backslash in the name of a log as a sign of its own.
case $output in
    *\\*)
        printf '%s: %s: expected a name without a backslash\n' "$0" "$output" >&2
        exit 2
        ;;
esac

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

root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
program=${NEPHRITE:-$root/build/release/nephrite}
if ! command -v "$program" > /dev/null; then
    echo "$0: $program: there is no such program" >&2
    exit 1
fi

case $verb in
    reference) stem=${output%.exr} folder=$(dirname "$output") ;;
    sweep) stem=$output/sweep folder=$output ;;
esac
mkdir -p "$folder"
if [ -n "$errors" ]; then mkdir -p "$(dirname "$errors")"; fi
# Logs are named after the output, so that other pictures of the folder keep theirs. To sbatch, %% is a %.
log=$(printf '%s\n' "$stem" | sed 's/%/%%/g')

# All that jobs need reaches them as arguments: names with blanks stay whole, and SBATCH_EXPORT=NONE does no harm.
set -- "$program" "$verb" "$parts" "$output" "$stem" "${errors%.exr}" "$@"
array=$(sbatch --parsable --array="1-$parts" --cpus-per-task="${CPUS:-1}" --job-name="$verb" \
    --output="$log.part-%a.log" /dev/stdin "$@" <<'JOB'
#!/bin/sh
program=$1 verb=$2 part=$SLURM_ARRAY_TASK_ID/$3 output=$4 stem=$5.part-$SLURM_ARRAY_TASK_ID errors=$6
shift 6
if [ "$verb" = sweep ]; then exec "$program" sweep "$@" --part "$part" -o "$output"; fi
if [ -n "$errors" ]; then set -- "$@" --stderr "$errors.part-$SLURM_ARRAY_TASK_ID.exr"; fi
# More than CPUS where whole nodes are asked for.
exec "$program" reference "$@" --threads "${SLURM_CPUS_ON_NODE:-1}" --part "$part" -o "$stem.exr"
JOB
)
sbatch --parsable --dependency="afterok:${array%%;*}" --kill-on-invalid-dep=yes --job-name="$verb-merge" \
    --output="$log.merge.log" /dev/stdin "$@" <<'JOB'
#!/bin/sh
set -eu
program=$1 verb=$2 parts=$3 output=$4 picture=$5 errors=$6
shift 6
# All runs of a sweep are done: what is left of it are its tables.
if [ "$verb" = sweep ]; then exec "$program" sweep "$@" -o "$output"; fi
for stem in "$picture" "$errors"; do
    [ -n "$stem" ] || continue
    set --
    for part in $(seq "$parts"); do set -- "$@" "$stem.part-$part.exr"; done
    "$program" merge "$@" -o "$stem.exr"
done
JOB
