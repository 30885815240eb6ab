#!/usr/bin/env bash
# Runs every check of the project: format, lints, docs, all tests. Needs Rust, Node and Python 3.
set -euo pipefail
cd "$(dirname "$0")"

cargo fmt --all --check
cargo clippy --workspace --all-targets -- -D warnings
# Units in brackets, like [m], look like links to rustdoc.
RUSTDOCFLAGS="-D warnings -A rustdoc::broken-intra-doc-links" cargo doc --workspace --no-deps --lib
cargo test --workspace
cargo build
bash scripts/check-docs.sh target/debug/dalembert

if command -v npm >/dev/null; then
    (cd viewer && npm ci --no-audit --no-fund && npm test)
    bash scripts/viewer-test.sh target/debug/dalembert
else
    echo "npm is missing: the tests of the viewer were left out (install Node 20 or newer)" >&2
    exit 1
fi
