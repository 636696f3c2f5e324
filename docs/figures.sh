#!/usr/bin/env bash
# figures.sh [KDSCOPE [FOLDER]]: makes the pictures of README.md and docs/*.md that need no window anew, into docs/images
# unless told otherwise. Those of the window: screenshots.sh.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
kdscope=$(realpath -- "${1:-$root/build/release/kdscope}")
folder=$(realpath -- "${2:-$root/docs/images}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$kdscope" gallery -o gallery >/dev/null
for name in ball-9000-nodes ball-9000-splits scatter-10000-divergence lantern-beauty; do
    cp "gallery/$name.png" "$folder/"
    echo "$folder/$name.png"
done
"$kdscope" render rooms --map oracle --rules as-published -o "$folder/rooms-oracle.png" >/dev/null
echo "$folder/rooms-oracle.png"
"$kdscope" render sheet:10000 --map steps-saved --entry-tile 8 -o "$folder/sheet-steps-saved.png" >/dev/null
echo "$folder/sheet-steps-saved.png"
"$kdscope" render ball:9000 --overlay --overlay-colour ratio --overlay-depth 7 -o "$folder/ball-9000-ratio.png" >/dev/null
echo "$folder/ball-9000-ratio.png"
"$kdscope" stats ball:9000 --divergence --traversal restart --rays primary --svg width.svg >/dev/null
convert -density 110 width.svg -strip "$folder/width-ball-restart.png"
echo "$folder/width-ball-restart.png"
