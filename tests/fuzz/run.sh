#!/usr/bin/env bash
# Builds and runs the fuzzers. See usage below, or README.md.
set -euo pipefail
cd "$(dirname "$0")/../.."

readonly here=tests/fuzz
readonly folder=build-fuzz
readonly skipped=77 # what CTest takes for "skipped"

usage() {
    cat <<'TEXT'
usage: tests/fuzz/run.sh build | short NAME [RUNS] | long NAME [SECONDS]
  build   build the fuzzers into build-fuzz/
  short   a repeatable run from the seeds alone, of RUNS inputs (default: 10000) in some seconds
  long    a run of SECONDS (default: 3600) that keeps what it learns in build-fuzz/found/NAME/
NAME is scene, model, texture, picture or film. An input that fails is kept as build-fuzz/NAME-*.
TEXT
}

# Sets clang_version to that of the compiler that cmake/Clang.cmake chooses.
require_clang() {
    for clang_version in 16 17 18 19 20 21; do
        if command -v "clang++-$clang_version" >/dev/null; then
            return
        fi
    done
    echo "Skipped: there is no clang++-16 or later (Debian 12: clang-16 and libclang-rt-16-dev)"
    exit "$skipped"
}

build() {
    cmake -S "$here" -B "$folder" -G Ninja --log-level=WARNING
    cmake --build "$folder" && return
    # Clang refuses a precompiled header if a package upgrade has changed a header in it.
    find "$folder" -name '*.pch' -delete
    cmake --build "$folder"
}

# fuzz NAME FOUND OPTION...: new inputs go to the folder FOUND. Ten seconds are enough for one
# input, and 2 GiB for what a few kilobytes can request.
fuzz() {
    local name=$1 found=$2
    shift 2
    local dictionary=$here/dictionaries/$name.dict
    [[ -e $dictionary ]] || dictionary=$folder/$name.dict
    ASAN_SYMBOLIZER_PATH=$(command -v "llvm-symbolizer-$clang_version" || true) \
        "$folder/${name}_fuzzer" "$found" "$here/corpus/$name" -dict="$dictionary" \
        -artifact_prefix="$folder/$name-" -keep_seed=1 -max_len=4096 -timeout=10 \
        -rss_limit_mb=2048 -malloc_limit_mb=1024 -print_final_stats=1 "$@"
}

[[ $# -ge 1 && $1 == build || $# -ge 2 ]] || {
    usage >&2
    exit 2
}
require_clang
case "$1" in
build)
    build
    ;;
short)
    found=$(mktemp -d)
    trap 'rm -rf "$found"' EXIT
    # The time only matters on a machine that is too slow for that many runs.
    fuzz "$2" "$found" -seed=1 -runs="${3:-10000}" -max_total_time=20
    ;;
long)
    mkdir -p "$folder/found/$2"
    fuzz "$2" "$folder/found/$2" -max_total_time="${3:-3600}"
    ;;
*)
    usage >&2
    exit 2
    ;;
esac
