#!/usr/bin/env bash
# tests/install/packages_test.sh
#
# Builds the Debian packages, has lintian look at them, and does what a stranger would:
# installs them in a Debian 12 of nothing else and runs the first commands of the README,
# a program of Python and one of C++. Says how long each took and what the packages have.
# Some minutes beside the build; wants lintian and mmdebstrap, and either root or user
# namespaces.
set -euo pipefail

say() { printf '\n== %s\n' "$*"; }

# timed COMMAND…: runs it silently and says how long it took.
timed() {
  local begin=$EPOCHREALTIME
  "$@" >/tmp/output 2>&1 || {
    cat /tmp/output
    echo "failed: $*" >&2
    exit 1
  }
  local line="$*"
  awk "BEGIN { printf \"%8.1f s  \", $EPOCHREALTIME - $begin }"
  echo "${line:0:70}"
}

# printed PATTERN: the last timed command did.
printed() {
  grep -q -- "$1" /tmp/output || {
    cat /tmp/output
    echo "the output does not match $1" >&2
    exit 1
  }
}

# In the clean system, where this file and the packages lie in /tmp/packages.
as_stranger() {
  export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
  cd /tmp/packages
  say "the first picture, in two commands"
  # As Debian does by itself; mmdebstrap may have turned it off.
  timed apt-get -o APT::Install-Recommends=true install -y ./*.deb
  cd /usr/share/brachisto
  timed brachisto solve problems/case.yaml --out /tmp/track
  printed 'verdict  *verified'
  grep -q '</svg>' /tmp/track/path.svg

  say "what else they promise"
  # docs/validation.md, reference_case.
  timed brachisto solve problems/paper/fig04_reference_case.yaml
  printed 'τ = T √(2g/H) = 5\.09344446'
  cat >/tmp/case.py <<'END'
import brachisto
case = brachisto.Scene.from_file("problems/paper/fig04_reference_case.yaml")
print(brachisto.solve(case))
END
  timed python3 /tmp/case.py
  printed 'verified, tau = 5\.09344446'
  ldconfig -p | grep -q 'libbrachisto\.so\.'
  timed apt-get install -y --no-install-recommends g++ pkg-config
  timed bash -c "g++ -std=c++20 /tmp/packages/solve_scene.cpp -o /tmp/solve_scene \
    \$(pkg-config --cflags --libs brachisto)"
  timed /tmp/solve_scene
  printed 'tau = 5\.09344446'

  say "nothing is left of them"
  timed apt-get purge -y '*brachisto*'
  if find / -xdev -path /tmp -prune -o -path /proc -prune -o -path /var -prune \
    -o -name '*brachisto*' -print | grep .; then
    exit 1
  fi
}

if [ "${1:-}" = --as-stranger ]; then
  as_stranger
  exit
fi

cd "$(dirname "$0")/../.."
./bootstrap.sh packages
stranger=$(mktemp -d)
trap 'rm -rf "$stranger"' EXIT
mkdir "$stranger/packages"
cp build/packages/debs/*.deb tests/install/programs/solve_scene.cpp \
  tests/install/packages_test.sh "$stranger/packages"
chmod -R a+rX "$stranger"

for deb in "$stranger"/packages/*.deb; do
  say "$(basename "$deb"): $(stat -c %s "$deb") bytes"
  dpkg-deb --field "$deb" Depends Recommends Installed-Size
  dpkg-deb --contents "$deb" | awk '{ n++; kind = $6; sub(/^\.\/usr\//, "", kind)
      split(kind, part, "/"); size[part[1] "/" part[2]] += $3 }
    END { for (p in size) if (size[p]) printf "%10d  %s\n", size[p], p }' | sort -k2
done

say "lintian"
lintian --fail-on error,warning "$stranger"/packages/*.deb

say "a Debian 12 of nothing else"
mmdebstrap --quiet --variant=apt --format=null \
  --customize-hook="copy-in $stranger/packages /tmp" \
  --customize-hook="chroot \"\$1\" bash /tmp/packages/packages_test.sh --as-stranger" \
  bookworm
