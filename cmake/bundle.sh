#!/usr/bin/env bash
# bundle.sh DESTINATION [PROGRAM...]: copies programs and every shared library they need into one folder, so that they run
# on a machine that has only a graphics driver. The C library and OpenGL stay the machine's own. Start them through
# DESTINATION/start, as in `DESTINATION/start kdscope info`. Without PROGRAM: build/release/kdscope.
set -euo pipefail

if [[ $# -lt 1 ]]; then
    echo "usage: bundle.sh DESTINATION [PROGRAM...]" >&2
    exit 2
fi
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
destination=$1
shift
[[ $# -gt 0 ]] || set -- "$root/build/release/kdscope"

own='^(linux-vdso|ld-linux|libc|libm|libdl|libpthread|librt|libGL|libEGL|libGLX|libGLdispatch|libOpenGL)\b'
mkdir -p "$destination/lib" "$destination/bin" "$destination/share/kdscope"
cp -r "$root/assets" "$destination/share/kdscope/"
for program; do
    cp "$program" "$destination/bin/"
    ldd "$program" | awk '$3 ~ /^\// { print $3 }' | while read -r library; do
        [[ $(basename "$library") =~ $own ]] || cp -Lu "$library" "$destination/lib/"
    done
done
find "$destination/bin" -type f -exec strip {} +

cat >"$destination/start" <<'SCRIPT'
#!/usr/bin/env bash
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
export LD_LIBRARY_PATH="$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
exec "$here/bin/$1" "${@:2}"
SCRIPT
chmod +x "$destination/start"
echo "$destination: $(du -sh "$destination" | cut -f1)"
