# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
# What scripts/setup, scripts/demo and scripts/test share. Sourced, never run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
package_list=$root/scripts/packages.txt

fail() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

step() {
  echo "== $*"
}

# Every package of the list, one a line.
packages() {
  sed -e 's/#.*//' -e 's/[[:space:]]*$//' -e '/^$/d' "$package_list"
}

# The packages of the list that dpkg does not know as installed, one a line.
missing_packages() {
  local installed
  installed=$(dpkg-query -W -f='${db:Status-Abbrev}${Package}\n' 2>/dev/null | sed -n 's/^.i. *//p')
  comm -13 <(sort -u <<<"$installed") <(packages | sort -u)
}

# The part of --help that says what the machine will get.
help_packages() {
  echo "What is installed, if it is missing, by apt-get from Debian 12 (as root or with sudo):"
  packages | fmt -w 96 | sed 's/^/  /'
  echo "scripts/packages.txt gives the reason for each. Everything else is written to build/ and to"
  echo "the compiler cache."
}

# prepare PRESET: installs, configures and builds what is not there yet.
prepare() {
  local preset=$1
  cd "$root"
  "$root/scripts/setup"
  if [ ! -f "build/$preset/build.ninja" ]; then
    step "configuring build/$preset"
    mkdir -p build
    cmake --preset "$preset" >"build/configure-$preset.log" 2>&1 || {
      cat "build/configure-$preset.log" >&2
      fail "cmake could not configure; the reason is above"
    }
  fi
  step "building build/$preset"
  cmake --build --preset "$preset" --parallel "$(nproc)" ||
    fail "the build failed; the first error is above"
}
