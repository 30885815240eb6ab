#!/usr/bin/env bash
# Checks the manual against the program: every example model is valid, the generated pages and the
# sessions that the pages show are up to date, every link leads somewhere.
# Usage: scripts/check-docs.sh PROGRAM
set -euo pipefail
program=$(realpath "${1:?usage: scripts/check-docs.sh PROGRAM}")
cd "$(dirname "$0")/.."

for model in docs/src/examples/*.toml; do
    case "$model" in
        # These show mistakes on purpose; the pages show what the program says of them.
        */mistake-*) continue ;;
    esac
    if ! answer=$("$program" check "$model" 2>&1); then
        echo "$model: dalembert check failed" >&2
        echo "$answer" >&2
        exit 1
    fi
done
# The examples that are templates.
for template in slider-crank four-bar pendulum planetary-gear spatial-slider-crank; do
    "$program" new "$template" | diff - "docs/src/examples/$template.toml"
done
"$program" schema | scripts/model-reference.py --check
scripts/docs-output.py "$program" --check
scripts/docs-links.py
