#!/usr/bin/env bash
# From a bare Debian 12 to a built, tested or demonstrated Weavefront. Run as root, or as a user who may use sudo.
set -euo pipefail

usage() {
    cat <<'TEXT'
usage: bash cmake/bootstrap.sh [setup|build|test|check|demo]
  setup   install the Debian packages that are missing (default)
  build   setup, then configure and build the release preset in build/release
  test    build, then run every test
  check   build with clang++ under sanitizers in build/sanitizers, run the tests that bear it, fuzz the readers for 60 s,
          count the lines covered, look for long functions with clang-tidy
  demo    setup, build the program, run the 428 m/s example on 2 ranks on a coarse mesh and draw it, in runs/demo
TEXT
}

packages=(
    g++ cmake ninja-build git clang-format black
    libopenmpi-dev openmpi-bin libhdf5-openmpi-dev hdf5-tools libmetis-dev libeigen3-dev libgtest-dev libbenchmark-dev valgrind
    libcli11-dev libyaml-cpp-dev libfmt-dev libspdlog-dev libudunits2-dev nlohmann-json3-dev libssl-dev libxxhash-dev
    libboost-dev
    python3 python3-h5py python3-matplotlib
)

check_packages=(clang clang-tidy libclang-rt-14-dev llvm gcovr) # of the command check alone

say() { printf '== %s\n' "$*"; }
die() {
    printf 'bootstrap.sh: %s\n' "$*" >&2
    exit 1
}

check_system() {
    local ID=unknown VERSION_ID='' PRETTY_NAME='this system'
    # shellcheck disable=SC1091
    if [ -r /etc/os-release ]; then . /etc/os-release; fi
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        die "$PRETTY_NAME has no apt; install the counterparts of these Debian 12 packages, then use cmake --preset release: ${packages[*]}"
    fi
    if [ "$ID" != debian ] || [ "$VERSION_ID" != 12 ]; then
        say "$PRETTY_NAME is not Debian 12, on which Weavefront is tested; going on"
    fi
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        die "installing packages needs root or sudo; ask for: apt-get install ${missing[*]}"
    fi
}

installed() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

setup() {
    check_system
    missing=()
    for package in "${packages[@]}"; do
        installed "$package" || missing+=("$package")
    done
    if [ ${#missing[@]} -eq 0 ]; then
        say 'all packages are installed'
        return
    fi
    say "installing ${missing[*]}"
    as_root apt-get update -q=2
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q=2 -o Dpkg::Use-Pty=0 --no-install-recommends "${missing[@]}" >/dev/null
}

# build [TARGETS...], all targets without arguments
build() {
    local targets=()
    if [ $# -gt 0 ]; then targets=(--target "$@"); fi
    say 'building in build/release'
    cmake --preset release
    cmake --build --preset release --parallel "$cores" "${targets[@]}"
}

check() {
    local build=build/sanitizers tidy
    packages+=("${check_packages[@]}")
    setup
    say "building in $build"
    cmake --preset sanitizers
    cmake --build --preset sanitizers --parallel "$cores"
    # Long functions are looked for in the time that the tests leave.
    cmake --preset sanitizers -B $build/tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >$build/tidy.log # clang-tidy reads none
    nice -n 19 run-clang-tidy -quiet -j "$cores" -p $build/tidy -checks='-*,readability-function-size' "$root/(src|partition)/" \
        >>$build/tidy.log 2>&1 &
    tidy=$!
    trap 'kill $tidy 2>/dev/null || true' EXIT
    ctest --preset sanitizers --parallel "$cores"
    say 'lines covered'
    gcovr --config cmake/gcovr.cfg -j "$cores" $build >$build/coverage.txt || die "too few lines are covered: see $build/coverage.txt"
    tail -n 4 $build/coverage.txt
    say 'long functions'
    wait $tidy || true # its log says what it has found
    trap - EXIT
    if grep -E 'warning:|error:' $build/tidy.log; then die 'clang-tidy objects'; fi
    grep -q 'clang-tidy.*simulation.cpp' $build/tidy.log || die "clang-tidy has not run: see $build/tidy.log"
}

prepare_mpirun() {
    if [ "$(id -u)" -eq 0 ]; then
        export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    fi
    export OMPI_MCA_btl_vader_single_copy_mechanism=none # needs ptrace rights, which containers lack
    if [ "$cores" -lt 2 ]; then
        export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1
    fi
}

demo() {
    local out=runs/demo
    prepare_mpirun
    say 'eight plies of Kevlar 129 hit at 428 m/s, coarse mesh, 2 ranks'
    mpirun -n 2 build/release/src/app/weavefront run examples/kevlar129_8ply/impact_428.yaml --set target.mesh.center='2 mm' --output "$out" --overwrite
    say 'drawing'
    build/release/bin/weavefront-plot "$out"
    say "results (open results.vtkhdf in ParaView 5.12 or newer), history and summary are in $root/$out, the pictures:"
    find "$root/$out" -name '*.png' | sort
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
cores=$(env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc) # nproc takes these for the cores there are

case "${1:-setup}" in
    setup) setup ;;
    build)
        setup
        build
        ;;
    test)
        setup
        build
        ctest --preset release --parallel "$cores"
        ;;
    check) check ;;
    demo)
        setup
        build weavefront
        demo
        ;;
    -h | --help | help) usage ;;
    *)
        usage >&2
        exit 2
        ;;
esac
