#!/bin/sh
# Installs what the tests take, builds, runs them. Safe to repeat.
#   sh tools/test.sh        all but the slow ones
#   sh tools/test.sh slow   the slow ones too
set -eu
cd "$(dirname "$0")/.."

case ${1:-} in
  "") selection="--label-exclude slow" ;;
  slow) selection="" ;;
  *)
    echo "test: found '$1'; accepted: nothing, or slow" >&2
    exit 2
    ;;
esac

sh tools/setup.sh build tests

echo "test: building build/release"
cmake --preset release -DPERCAL_TESTS=ON
cmake --build --preset release

echo "test: running"
ctest --preset release --parallel 2 --no-tests=error $selection
