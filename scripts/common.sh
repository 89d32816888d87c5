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

# packages PURPOSE: the packages of the list that `demo` or `test` needs, one a line. What demo needs
# stands first, and test needs it too.
packages() {
  local rest=()
  [ "$1" != demo ] || rest=(-e '/^\[test\]/,$d')
  sed "${rest[@]}" -e 's/#.*//' -e '/^\[/d' -e 's/[[:space:]]*$//' -e '/^$/d' "$package_list"
}

# missing_packages PURPOSE: those that dpkg does not know as installed, one a line.
missing_packages() {
  local installed
  installed=$(dpkg-query -W -f='${db:Status-Abbrev}${Package}\n' 2>/dev/null | sed -n 's/^.i. *//p')
  comm -13 <(sort -u <<<"$installed") <(packages "$1" | sort -u)
}

# help_packages [PURPOSE]: the part of --help that says what the machine will get.
help_packages() {
  echo "Packages that apt-get installs from Debian 12 or 13 if they are missing (as root or with sudo):"
  packages "${1:-test}" | fmt -w 96 | sed 's/^/  /'
  echo "scripts/packages.txt gives the reason for each. Everything else is written to build/ and to"
  echo "the compiler cache."
}

# timed PART COMMAND...: runs the command, keeps its seconds for print_times, gives its exit code.
timed_parts=()
timed_tenths=()
timed() {
  local part=$1 start=${EPOCHREALTIME/[.,]/} code=0
  shift
  "$@" || code=$?
  timed_parts+=("$part")
  timed_tenths+=($(((${EPOCHREALTIME/[.,]/} - start + 50000) / 100000)))
  return $code
}

# What each part took, and of the build what its steps took.
print_times() {
  local i sum=0
  step "seconds"
  for i in "${!timed_parts[@]}"; do
    sum=$((sum + timed_tenths[i]))
    printf '%-12s %7d.%d s\n' "${timed_parts[i]}" $((timed_tenths[i] / 10)) $((timed_tenths[i] % 10))
    if [ "${timed_parts[i]}" = build ]; then
      "$root/scripts/build_times" --longest 0 --since "$root/build/ninja_log_before" \
        "$build_folder/.ninja_log"
    fi
  done
  printf '%-12s %7d.%d s\n' "in all" $((sum / 10)) $((sum % 10))
}

# is_program_only FOLDER: whether a build folder is configured for the program alone.
is_program_only() {
  grep -qs '^DYNRT_PROGRAM_ONLY:BOOL=ON$' "$1/CMakeCache.txt"
}

# configure PRESET: CMake, its messages in a file unless it fails.
configure() {
  local log=$root/build/configure-$1.log
  cmake --preset "$1" >"$log" 2>&1 || {
    cat "$log" >&2
    fail "cmake could not configure; the reason is above"
  }
}

# prepare PRESET [program]: installs, configures and builds what is not there yet: everything that
# tests need, or the program alone.
prepare() {
  local preset=$1 purpose=test targets=(all tests)
  local settings=$preset
  build_folder=$root/build/$preset
  cd "$root"
  if [ "${2:-}" = program ]; then
    purpose=demo
    settings=program
    targets=(all)
    # Where everything was configured before, the program is a part of that.
    [ ! -f "$build_folder/build.ninja" ] || is_program_only "$build_folder" || targets=(dynrt)
  fi
  timed packages "$root/scripts/setup" --for $purpose
  mkdir -p build
  if [ ! -f "$build_folder/build.ninja" ] ||
    { [ $purpose = test ] && is_program_only "$build_folder"; }; then
    step "configuring build/$preset"
    timed configure configure "$settings"
  fi
  if [ -f "$build_folder/.ninja_log" ]; then
    cp "$build_folder/.ninja_log" build/ninja_log_before
  else
    echo "# ninja log" >build/ninja_log_before
  fi
  step "building build/$preset"
  timed build cmake --build "$build_folder" --target "${targets[@]}" --parallel "$(nproc)" ||
    fail "the build failed; the first error is above"
}
