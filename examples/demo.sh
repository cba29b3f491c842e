#!/bin/sh
# Two sums from this folder, drawn:  examples/demo.sh PROGRAM FOLDER
set -eu
program="$1"
out="$2"
here="$(dirname "$0")"
mkdir -p "$out"

show() {  # show TITLE NAME P Q
  echo "$1"
  report="$("$program" sum "$here/$3" "$here/$4" -o "$out/$2.wkt" --svg "$out/$2.svg" \
    --repeat 5 --verbose 2>&1)" || { echo "$report" >&2; exit 1; }
  echo "$report" | sed -e "s|^P  |  P  ($3):|" -e "s|^Q  |  Q  ($4):|" \
    -e 's|^P + Q|  sum:  |' -e 's|^time|  time: |'
  echo "  picture: $out/$2.svg   outline: $out/$2.wkt"
}

show "A region with many holes, grown by a disc of 32 corners:" coral coral.wkt disc32.wkt
show "A star plus the same star, slightly turned:" stars star.wkt star_turned.wkt
"$program" sum "$here/star.wkt" "$here/star_turned.wkt" -o "$out/stars.wkt" --trace "$out/stars-stages"
echo "The second one stage by stage (convolution, cover, loops, ...): $out/stars-stages/*.svg"
echo "The pictures open in any browser."
