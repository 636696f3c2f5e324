#!/usr/bin/env bash
# The stability suite with all rays of the notes, by all traversals on CPU and OpenGL.
set -euo pipefail

"$KDSCOPE" stability --long --json >long.json
echo "passed"
