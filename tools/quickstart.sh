#!/bin/sh
# From a bare Debian machine to a steel BB in gelatin: installs what the build takes, builds, shoots the BB. Safe to repeat:
# packages, objects and evaluations that are there are not made again.
set -eu
cd "$(dirname "$0")/.."

sh tools/setup.sh build

echo "quickstart: building build/release/percal"
cmake --preset release -DPERCAL_TESTS=OFF
cmake --build --preset release --target percal_program

echo "quickstart: a steel BB at 180 m/s into 10 % gelatin"
[ -e bb.toml ] || build/release/percal new scene -o bb.toml
build/release/percal impact bb.toml
echo "quickstart: bb.toml is yours to change; the program is build/release/percal, and docs/tutorial goes on from here"
