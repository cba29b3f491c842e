#!/bin/sh
# usage: install_packages.sh [--optional] [LIST...]     (LIST: packages.txt)
# Installs the missing Debian packages of all lists. If it cannot, it names them, and fails unless
# they are optional.
set -eu
failure=1
if [ "${1:-}" = --optional ]; then
  failure=0
  shift
fi
[ $# != 0 ] || set -- packages.txt
packages="$(cd "$(dirname "$0")/.." && sed -e 's/#.*//' "$@" | tr -s ' \t\n' ' ' |
  sed -e 's/^ //' -e 's/ $//')"

if [ "${MINKSUM_SKIP_DEPS:-0}" = 1 ]; then
  exit 0
fi
if ! command -v dpkg-query >/dev/null 2>&1; then
  echo "This is no Debian system, so nothing can be checked or installed here. What is needed:" >&2
  echo "  $packages" >&2
  echo "Install the like by other means, then set MINKSUM_SKIP_DEPS=1." >&2
  exit $failure
fi

# One query covers all packages; a package unknown to dpkg has no line in the answer.
installed=" $(dpkg-query -W -f='${db:Status-Abbrev}${Package}\n' $packages 2>/dev/null |
  sed -n 's/^ii *//p' | tr '\n' ' ')"
missing=""
for package in $packages; do
  case "$installed" in
    *" $package "*) ;;
    *) missing="$missing $package" ;;
  esac
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null 2>&1; then
  echo "Missing packages:$missing" >&2
  echo "Install them as root:  apt-get install$missing" >&2
  echo "or set MINKSUM_SKIP_DEPS=1 if their like is there by other means." >&2
  exit $failure
fi
echo "Installing$missing"
export DEBIAN_FRONTEND=noninteractive
{ apt-get update -qq && apt-get install -y -qq --no-install-recommends $missing >/dev/null; } || {
  echo "Could not install$missing" >&2
  exit $failure
}
