#!/bin/sh
# Installs the Debian packages of tools/packages.txt for the purposes given, those that are missing only:
#   sh tools/setup.sh build tests
# Works as root and with sudo. Does nothing, and asks for nothing, when everything is there.
set -eu
cd "$(dirname "$0")/.."

wanted=""
for purpose in "$@"; do
  names=$(sed -n "s/^$purpose  *//p" tools/packages.txt)
  if [ -z "$names" ]; then
    echo "setup: tools/packages.txt has no packages for '$purpose'" >&2
    exit 2
  fi
  wanted="$wanted $names"
done

if ! command -v dpkg-query >/dev/null 2>&1 || ! command -v apt-get >/dev/null 2>&1; then
  echo "setup: this is not Debian or one of its kin; the packages to have are, by their Debian names:" $wanted >&2
  echo "setup: going on as if they were there" >&2
  exit 0
fi

missing=""
for package in $wanted; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  case $status in
    "install ok installed") ;;
    *) missing="$missing $package" ;;
  esac
done
if [ -z "$missing" ]; then
  echo "setup: all packages for $* are installed"
  exit 0
fi

if [ "$(id -u)" -eq 0 ]; then
  as_root="env DEBIAN_FRONTEND=noninteractive"
elif command -v sudo >/dev/null 2>&1; then
  as_root="sudo env DEBIAN_FRONTEND=noninteractive"
else
  echo "setup: not root and no sudo; as root, run: apt-get install$missing" >&2
  exit 1
fi
echo "setup: installing$missing"
$as_root apt-get update -qq || echo "setup: apt-get update failed; trying with the package lists at hand" >&2
$as_root apt-get install -y -qq --no-install-recommends $missing
