#!/usr/bin/env bash
# From a fresh Debian 12 or 13 to a result with one command:
#
#   ./bootstrap.sh demo   install what is missing, build, solve the reference
#                         case of the paper
#   ./bootstrap.sh test   install what is missing, build, run all tests
#   ./bootstrap.sh bench  the same for the benchmarks, half an hour; results in
#                         build/release/benchmarks/results
#   ./bootstrap.sh packages
#                         the same for Debian packages, in build/packages/debs
#   ./bootstrap.sh page   install Chromium, build, test the pages in it
#   ./bootstrap.sh site   install pandoc, make a site of these documents that needs no network, in
#                         build/site
#   ./bootstrap.sh deps   only install what is missing
#
# Running it again is quick: only missing packages are installed and only what
# changed is built.
set -euo pipefail
cd "$(dirname "$0")"

packages=(
  g++ cmake ninja-build pkg-config
  coinor-libipopt-dev libmumps-seq-dev libsuitesparse-dev libeigen3-dev
  libboost-dev libyaml-cpp-dev libmuparser-dev libfmt-dev nlohmann-json3-dev
  libcli11-dev libsqlite3-dev libxxhash-dev libexpat1-dev libgtest-dev libgmock-dev gnuplot-nox fonts-dejavu-core
  libjs-dygraphs
)
# Arb, for proofs: from Debian 13 on a part of FLINT.
case "$(. /etc/os-release && echo "${VERSION_ID:-}")" in
  12) packages+=(libflint-arb-dev) ;;
  *) packages+=(libflint-dev) ;;
esac
# Of the Python module.
python_packages=(pybind11-dev python3-dev python3-numpy)
# Of the tests alone: a validator of others for the schemas, readers of others for DXF and .nl files,
# who reads the manual and the completions, what notebooks, wheels and type checks of Python use,
# and what spares the build of the other kind of library the compiler.
test_packages=(
  ccache
  python3-ezdxf python3-jsonschema python3-yaml "${python_packages[@]}" libamplsolver-dev
  groff-base mandoc man-db zsh fish python3-pandas mypy python3-pip python3-venv
)
# Of the page checks alone: the browser.
page_packages=(chromium)
# Of the benchmarks alone, the programs of others that they run and what reads .nl files among them.
bench_packages=(libbenchmark-dev libamplsolver-dev octave python3-scipy)

say() { printf '== %s\n' "$*"; }

install_packages() {
  local missing=() package
  for package in "${packages[@]}"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null |
      grep -q '^install ok installed$' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    say "all ${#packages[@]} packages are installed"
    return
  fi
  say "installing: ${missing[*]}"
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -qq
  DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq \
    --no-install-recommends "${missing[@]}" >/dev/null
}

# build TARGET [OPTION …]
build() {
  local target=$1
  shift
  say "building (preset release, in build/release)"
  # Files compiled several at a time take half the time when all are.
  cmake --preset release -DCMAKE_UNITY_BUILD=ON "$@" >build-configure.log 2>&1 || {
    cat build-configure.log
    exit 1
  }
  rm -f build-configure.log
  cmake --build --preset release --target "$target"
}

case "${1:-}" in
  deps)
    install_packages
    ;;
  demo)
    install_packages
    build brachisto_app -DBRACHISTO_BUILD_TESTS=OFF
    problem=problems/paper/fig04_reference_case.yaml
    say "brachisto solve $problem"
    build/release/src/app/brachisto solve "$problem"
    ;;
  test)
    packages+=("${test_packages[@]}")
    install_packages
    # Builds that lie beside each other share their objects, also where ctest, which empties
    # variables of the locale, begins one.
    export CCACHE_BASEDIR="${CCACHE_BASEDIR:-$PWD}" CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1 \
      CCACHE_SLOPPINESS=locale
    # The Python whose packages these are, whatever else is in the PATH.
    build all -DBRACHISTO_BUILD_TESTS=ON -DBRACHISTO_BUILD_PYTHON=ON \
      -DPython3_EXECUTABLE=/usr/bin/python3
    say "testing"
    ctest --preset release
    ;;
  page)
    packages+=("${page_packages[@]}")
    install_packages
    build all -DBRACHISTO_BUILD_TESTS=ON
    ctest --preset release -R '^page$'
    ;;
  bench)
    packages+=("${bench_packages[@]}")
    install_packages
    build run_benchmarks -DBRACHISTO_BUILD_TESTS=OFF \
      -DBRACHISTO_BUILD_BENCHMARKS=ON
    ;;
  packages)
    packages+=("${python_packages[@]}" dpkg-dev file)
    install_packages
    rm -rf build/packages/debs
    cmake --workflow --preset packages
    ls -l build/packages/debs/*.deb
    ;;
  site)
    packages=(pandoc)
    install_packages
    site=build/site
    rm -rf "$site" && mkdir -p "$site"
    git ls-files 'docs/*' 'problems/*' CITATION.cff LICENSE | grep -v '\.md$' |
      xargs cp --parents -t "$site"
    for page in *.md docs/*.md benchmarks/README.md; do
      up=$(dirname "$page" | sed 's|^\.$||; s|[^/][^/]*|../|')
      mkdir -p "$site/$(dirname "$page")"
      pandoc --from=gfm+tex_math_dollars --to=html5 --mathml --standalone \
        --lua-filter=src/cmake/site/page.lua --include-in-header=<(
          printf '<style>\n%s\n</style>\n' "$(<src/cmake/site/site.css)") \
        --include-before-body=<(printf '<nav><a href="%sdocs/index.html">brachisto</a></nav>\n' "$up") \
        --output="$site/${page%.md}.html" "$page"
    done
    say "$site/docs/index.html"
    ;;
  *)
    sed -n '2,17s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac
