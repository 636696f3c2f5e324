# What the scripts ask of a file that `kdscope stability --json` wrote. Sourced.

cases_in() { grep -o '"case": "T[0-9]*"' "$1" | sort -u | wc -l; }

# rows_of KEY VALUE FILE
rows_of() { grep -c "\"$1\": \"$2\"" "$3" || true; }

# Cases with a row of this verdict, each followed by a space.
cases_with_verdict() {
    awk -F'"' -v verdict="$1" '/"case":/ { id = $4 } /"verdict":/ && $4 == verdict { print id }' "$2" |
        sort -u | tr '\n' ' '
}

# Cases with a row of mismatches, each followed by a space.
cases_with_mismatches() {
    awk -F'"' '/"case":/ { id = $4 } /"mismatches": [1-9]/ { print id }' "$1" | sort -u | tr '\n' ' '
}

# mismatches_of CASE FILE: of the walks on the CPU in their order, "3/14/15".
mismatches_of() {
    awk -F'"' -v wanted="$1" '/"case":/ { id = $4 } /"tracer":/ { tracer = $4 }
        /"mismatches":/ && id == wanted && tracer == "cpu" { gsub(/[^0-9]/, "", $3); printf "%s%s", sep, $3; sep = "/" }' "$2"
}
