# Sourced by the scripts beside it: goes to the root of the tree and keeps every cache inside build/, so that no home
# folder is needed and no other program's cache is read.
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mkdir -p build/cache/mesa
export XDG_CACHE_HOME="$PWD/build/cache"
export MESA_SHADER_CACHE_DIR="$PWD/build/cache/mesa"
