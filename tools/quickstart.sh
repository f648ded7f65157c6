#!/bin/sh
# From a bare Debian machine to the identified skin: installs what the build takes, builds, runs the main job. Safe to repeat:
# packages, objects and evaluations that are there are not made again.
set -eu
cd "$(dirname "$0")/.."

sh tools/setup.sh build

echo "quickstart: building build/release/percal"
cmake --preset release -DPERCAL_TESTS=OFF
cmake --build --preset release --target percal_program

echo "quickstart: identifying the skin of data/guha2009/skin.toml, five minutes on two cores the first time"
build/release/percal identify data/guha2009/skin.toml --out skin.out
echo "quickstart: the result is skin.out/result.json, the material cards are beside it"
