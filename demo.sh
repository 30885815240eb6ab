#!/usr/bin/env bash
# From a model file to its mobility, its motion, the forces that it takes, and an animated page.
# Needs Rust and Node.
set -euo pipefail
cd "$(dirname "$0")"

cargo build --release
dalembert=target/release/dalembert
mkdir -p target/demo
"$dalembert" new slider-crank > target/demo/slider-crank.toml
"$dalembert" check target/demo/slider-crank.toml
"$dalembert" inverse target/demo/slider-crank.toml --out target/demo/slider-crank.csv \
    --plot "motor.moment,slider.x,A.force_x,A.force_y" --plot-file target/demo/slider-crank.svg
"$dalembert" view target/demo/slider-crank.toml
echo "open target/demo/slider-crank.html in a browser"
