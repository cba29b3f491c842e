#!/bin/sh
# usage: run.sh BUILD PROGRAM TEST...
# Starts a server of its own in a temporary folder, with the extensions that BUILD has, runs TESTS
# against it, and ends it. A test is a Python file, by its path from this folder, or `regress`: then
# PostgreSQL's pg_regress runs regress/sql/*.sql and compares what psql prints with
# regress/expected. Nothing is installed. The server does not run as root, so root becomes the user
# `postgres`.
set -eu
build="$1"
program="$2"
shift 2
here="$(cd "$(dirname "$0")" && pwd)"
folder="$(mktemp -d "${TMPDIR:-/tmp}/minksum-sql-XXXXXX")"
trap 'rm -rf "$folder"' EXIT
# The other user may not see the folders of root, so it gets copies.
DESTDIR="$folder" cmake --install "$build" --component sql >"$folder/installed"
mkdir "$folder/tests" "$folder/docs" "$folder/docs/img"
for test in "$@"; do cp -r "$here/$test" "$folder/tests"; done
cp "$here/support.py" "$folder/tests"
cp "$program" "$folder/minksum"
cp "$here/../../docs/sql.md" "$folder/docs"
cp "$here"/../../docs/img/sql-*.svg "$folder/docs/img"
cp -r "$here/../../examples" "$folder/examples"
chmod -R a+rX "$folder"
become=""
if [ "$(id -u)" = 0 ]; then
  chown -R postgres "$folder"
  become="runuser -u postgres --"
fi
# Debian's PostgreSQL looks for extensions below extension_destdir first.
cd "$folder"
# Servers that start at one time would choose the same port.
port="$(python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')"
cat >run_tests <<'END'
set -u
for test in "$@"; do
  if [ "$test" = regress ]; then
    "$(dirname "$(pg_config --pgxs)")/../test/regress/pg_regress" --bindir="$(pg_config --bindir)" \
      --inputdir=tests/regress --outputdir=tests/regress --host=localhost --port="$PGPORT" \
      --load-extension=postgis --load-extension=minksum --load-extension=minksum_postgis \
      functions inputs || { cat tests/regress/regression.diffs; exit 1; }
  else
    python3 -B "tests/${test##*/}" || exit 1
  fi
done
END
MINKSUM_PROGRAM="$folder/minksum" $become pg_virtualenv -t -v "${MINKSUM_PG_VERSION:-15}" \
  -c "--port=$port" -o fsync=off -o extension_destdir="$folder" -o max_worker_processes=8 \
  sh run_tests "$@"
