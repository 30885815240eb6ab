#!/usr/bin/env bash
# Opens pages that the program writes in a headless Chromium: each must draw its first picture,
# without an error on the console. Run it from the root of the repository.
#
#   scripts/viewer-test.sh [PROGRAM]      PROGRAM: default target/debug/dalembert
#
# PICTURES=folder keeps the pictures. Without Chromium (root installs it with apt-get) the test is
# skipped; with REQUIRE_CHROMIUM=1 it then fails.
set -euo pipefail

program=${1:-${CARGO_TARGET_DIR:-target}/debug/dalembert}
templates=(slider-crank pendulum spatial-slider-crank)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
pictures=${PICTURES:-$work}
mkdir -p "$pictures"

fail() {
    echo "viewer-test: FAILED: $*" >&2
    exit 1
}

find_chromium() {
    local name
    for name in chromium chromium-browser google-chrome; do
        command -v "$name" && return 0
    done
    return 1
}

if ! chromium=$(find_chromium); then
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
        echo "viewer-test: installing chromium"
        { apt-get update && apt-get install -y --no-install-recommends chromium; } >"$work/apt.log" 2>&1 ||
            tail -n 5 "$work/apt.log"
    fi
    if ! chromium=$(find_chromium); then
        [ -z "${REQUIRE_CHROMIUM:-}" ] || fail "there is no Chromium"
        echo "viewer-test: SKIPPED: there is no Chromium, and it could not be installed"
        exit 0
    fi
fi

# The sandbox of Chromium cannot be used by root and in containers; the pages are our own.
# Pictures in space are drawn by its software renderer: test machines have no graphics card.
browse() {
    timeout 120 "$chromium" --headless --no-sandbox --disable-dev-shm-usage \
        --use-angle=swiftshader --enable-unsafe-swiftshader --ignore-gpu-blocklist \
        --user-data-dir="$work/profile" --window-size=1280,800 --virtual-time-budget=4000 \
        --enable-logging=stderr --v=0 "$@"
}

# check NAME PAGE FRAGMENT: the page draws itself and is not blank.
check() {
    local name=$1 page=$2 fragment=$3 address picture size
    address="file://$page$fragment"
    browse --dump-dom "$address" >"$work/$name.dom" 2>"$work/$name.log" ||
        fail "$name: Chromium failed: $(tail -n 3 "$work/$name.log")"
    # Errors of the page, uncaught or written, are lines "...:CONSOLE...".
    if grep -a 'CONSOLE' "$work/$name.log"; then
        fail "$name: the console is not silent"
    fi
    grep -q 'data-state="drawn"' "$work/$name.dom" || fail "$name: nothing was drawn"
    picture="$pictures/$name.png"
    browse --screenshot="$picture" "$address" 2>>"$work/$name.log" >&2
    [ -s "$picture" ] || fail "$name: there is no picture"
    size=$(stat -c %s "$picture")
    # A drawing has far more detail than a page of one colour.
    [ "$size" -gt $((2 * blank)) ] || fail "$name: the picture is blank ($size bytes)"
    echo "viewer-test: $name: $size bytes"
}

[ -x "$program" ] || fail "$program is not there; build it first"
printf '<!doctype html><body style="background:#fcfcfa"></body>' >"$work/blank.html"
browse --screenshot="$work/blank.png" "file://$work/blank.html" 2>/dev/null >&2
[ -s "$work/blank.png" ] || fail "Chromium takes no pictures"
blank=$(stat -c %s "$work/blank.png")

for template in "${templates[@]}"; do
    "$program" new "$template" >"$work/$template.toml"
    "$program" view "$work/$template.toml" --html "$work/$template.html" >"$work/$template.txt" ||
        fail "$template: the program wrote no page"
    check "$template" "$work/$template.html" "#t=0.1"
    check "$template-forces" "$work/$template.html" "#t=0.1&forces=1"
    cmp -s "$pictures/$template.png" "$pictures/$template-forces.png" &&
        fail "$template: no force is shown"
done

# Machines in space, from the samples of the viewer (their motions need no program).
if [ -d viewer/node_modules ]; then
    (cd viewer && npm run --silent build && npm run --silent samples) >"$work/samples.log" ||
        fail "the samples of the viewer were not written: $(tail -n 3 "$work/samples.log")"
    for sample in sliderCrankInSpace forms joints meshes; do
        check "$sample" "$PWD/viewer/dist/samples/$sample.html" "#t=0.4"
    done
    sample=sliderCrankInSpace
    for wish in forces=1 frames=1 axes=1 from=z; do
        check "$sample-${wish%=*}" "$PWD/viewer/dist/samples/$sample.html" "#t=0.4&$wish"
        cmp -s "$pictures/$sample.png" "$pictures/$sample-${wish%=*}.png" && fail "$sample: $wish shows nothing"
    done
else
    echo "viewer-test: machines in space were left out (npm ci --prefix viewer)"
fi

# A page whose data are broken says so instead of staying empty, and the test would see it.
sed 's/"format":"dalembert-animation/"format":"other/' "$work/${templates[0]}.html" >"$work/broken.html"
browse --dump-dom "file://$work/broken.html" >"$work/broken.dom" 2>/dev/null
grep -q 'data-state="failed"' "$work/broken.dom" || fail "a broken page does not say that it failed"
echo "viewer-test: passed"
