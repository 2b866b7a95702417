#!/bin/sh
# documents.sh COMMAND DOCS SHARE: the manual, the completions of shells and the schemas, laid
# out below SHARE as below share of an installation, from what the command says of itself and
# from the table of keys in DOCS.
set -eu
command=$1 docs=$2 share=$3
here=$(dirname "$0")
rm -rf "$share"
mkdir -p "$share/man/man1" "$share/man/man5" "$share/brachisto/schemas"
cp -R "$here/share/." "$share"
for kind in problem result; do
  "$command" schema $kind > "$share/brachisto/schemas/$kind.schema.json"
done
version=$("$command" --version | sed -n 's/^brachisto //p')
page() {
  LC_ALL=C awk -v page="$1" -v version="$version" -f "$here/manual/roff.awk" -f "$here/manual/verb.awk" \
    > "$share/man/man1/$1.1"
}
"$command" --help | page brachisto
for verb in $("$command" complete -- '' | sed -n '/^-/!s/	.*//p'); do
  "$command" "$verb" --help | page "brachisto-$verb"
done
LC_ALL=C awk -v version="$version" -f "$here/manual/roff.awk" -f "$here/manual/problem.awk" \
  "$docs/problem-files.md" > "$share/man/man5/brachisto-problem.5"
