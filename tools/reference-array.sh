#!/bin/sh
# Renders a reference as a Slurm job array and merges its parts:
#     tools/reference-array.sh PARTS OUTPUT.exr SCENE [OPTIONS OF nephrite reference]...
exec "$(dirname "$(readlink -f "$0")")/slurm-array.sh" reference "$@"
