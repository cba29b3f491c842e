#!/bin/sh
# usage: make_docs.sh BUILD
# Makes the site of all pages and of the reference: BUILD/docs/html/index.html. A public name
# without documentation, a link that leads nowhere, and every other warning is a failure.
set -eu
cd "$(dirname "$0")/.."
mkdir -p "$1/docs"
MINKSUM_DOCS="$(cd "$1/docs" && pwd)"
export MINKSUM_DOCS
python="$MINKSUM_DOCS/python"

if ! cmp -s docs/requirements.txt "$python/requirements.txt"; then
  rm -rf "$python"
  python3 -m venv "$python"
  "$python/bin/pip" install --quiet --disable-pip-version-check -r docs/requirements.txt
  cp docs/requirements.txt "$python"
fi
rm -rf "$MINKSUM_DOCS/xml" "$MINKSUM_DOCS/html"
doxygen docs/Doxyfile
"$python/bin/sphinx-build" --quiet --fail-on-warning --nitpicky --fresh-env -c docs \
  -d "$MINKSUM_DOCS/pages" . "$MINKSUM_DOCS/html"
echo "The pages begin at $1/docs/html/index.html"
