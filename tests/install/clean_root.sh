#!/usr/bin/env bash
# What a new machine would see: a Debian of the given release from nothing, and
# in it a command of this checkout, the tests unless told otherwise.
#
#   tests/install/clean_root.sh trixie
#   tests/install/clean_root.sh bookworm ./bootstrap.sh demo
#
# As root, with mmdebstrap, a mirror of Debian and some 6 GB in TMPDIR. Takes the
# last commit and leaves nothing behind; KEEP=1 leaves the root.
set -euo pipefail
suite=${1:?a release of Debian, such as trixie}
shift
[ $# -gt 0 ] || set -- ./bootstrap.sh test
checkout=$(cd "$(dirname "$0")/../.." && pwd)
mirror=${MIRROR:-http://deb.debian.org/debian}
root=$(mktemp -d "${TMPDIR:-/tmp}/brachisto-$suite-XXXXXX")

leave() {
  umount "$root/proc" "$root/dev/pts" "$root/dev" 2>/dev/null || true
  if [ -n "${KEEP:-}" ]; then echo "== the root is $root"; else rm -rf --one-file-system "$root"; fi
}
trap leave EXIT

echo "== Debian $suite"
mmdebstrap --variant=minbase --include=ca-certificates "$suite" "$root" "$mirror"
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
mount --bind /dev/pts "$root/dev/pts"  # terminals, which tests open
cp /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/brachisto"
git -C "$checkout" archive HEAD | tar x -C "$root/brachisto"

echo "== $*"
start=$SECONDS
# A TMPDIR of this system is not in that one.
env -u TMPDIR chroot "$root" /bin/bash -c 'cd /brachisto && exec "$@"' - "$@"
echo "== done in $((SECONDS - start)) s"
