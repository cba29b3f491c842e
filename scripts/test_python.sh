#!/bin/sh
# usage: test_python.sh BUILD     builds the Python package of the libraries in the folder BUILD,
# installs it into an environment below BUILD, and runs its tests there. PYTHON names the
# interpreter (python3 without it).
set -eu
root="$(cd "$(dirname "$0")/.." && pwd)"
mkdir -p "$1"
build="$(cd "$1" && pwd)"
environment="$build/python-environment"
[ -x "$environment/bin/python" ] || "${PYTHON:-python3}" -m venv "$environment"
# The folder of the build is kept, so that the next run compiles only what has changed.
"$environment/bin/python" -m pip install --quiet --disable-pip-version-check \
  -Cbuild-dir="$build/python" -Ccmake.define.MINKSUM_BUILT="$build" "$root[test]"
cd "$root"
MINKSUM_PROGRAM="$environment/bin/minksum" "$environment/bin/python" -m pytest
