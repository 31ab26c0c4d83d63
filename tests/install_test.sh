#!/usr/bin/env bash
# What a user of the library does: installs it, and builds against it in each of the usual ways.
# install_test.sh BUILD SOURCE COMPILER FLAGS COLD_FLAGS: the build and its sources, and how they are compiled.
set -euo pipefail
build="$1" source="$2" compiler="$3" flags="$4" cold_flags="$5"
tree="$build/installed" work="$build/consumers"
rm -rf "$tree" "$work"
mkdir -p "$work"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

says_contact() { [ "$("$1")" = "contact at 8" ] || fail "$1 says something else"; }

# logged NAME COMMAND: its output is shown only if it fails.
logged() {
  local log="$work/$1.log"
  shift
  "$@" >>"$log" 2>&1 || {
    tail -n 40 "$log" >&2
    fail "$*"
  }
}

# configured NAME CMAKE_ARGS: the project of tests/consumer.
configured() {
  local name="$1"
  shift
  logged "$name" cmake -S "$source/tests/consumer" -B "$work/$name" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" \
    -DHELLO="$source/examples/hello.cpp" "$@"
}

# Consumers get the public headers and the language, nothing else of how taut is built.
inherits_nothing() {
  local commands
  commands="$(grep -E '"command".*(hello|plugin)\.cpp' "$1/compile_commands.json")"
  if grep -E -- '-W[a-z]|-ffp|/src( |$)' <<<"${commands//$flags/}"; then fail "a consumer inherits options of taut"; fi
}

# consumer NAME CMAKE_ARGS: the same, built and run.
consumer() {
  configured "$@"
  logged "$1" cmake --build "$work/$1" --target hello plugin
  says_contact "$work/$1/hello"
  inherits_nothing "$work/$1"
}

cmake --install "$build" --prefix "$tree" >"$work/install.log"
for file in bin/taut bin/taut-verify include/taut/taut.hpp share/man/man1/taut.1 \
  share/bash-completion/completions/taut share/zsh/site-functions/_taut share/fish/vendor_completions.d/taut.fish; do
  [ -s "$tree/$file" ] || fail "$file is not installed"
done
[ -s "$tree/share/taut/integrations/freecad/Taut.FCMacro" ] || fail "integrations are not installed"
[ ! -f "$build/../web/viewer.html" ] || [ -s "$tree/share/taut/viewer.html" ] || fail "the viewer's page is not installed"
"$tree/bin/taut" --version >/dev/null

# Wherever it is moved to.
mv "$tree" "$tree.moved"
tree="$tree.moved"
trap 'rm -rf "$tree"' EXIT

consumer package -DCMAKE_PREFIX_PATH="$tree"

if command -v pkg-config >/dev/null; then
  PKG_CONFIG_PATH="$(dirname "$(find "$tree" -name taut.pc)")"
  export PKG_CONFIG_PATH
  # shellcheck disable=SC2046  # words are meant to be split
  "$compiler" -std=c++20 "$source/examples/hello.cpp" $(pkg-config --cflags --libs taut) -o "$work/hello"
  says_contact "$work/hello"
else
  echo "no pkg-config here: skipped"
fi

# From the sources. Where many files are compiled as one, as in .ci/run, all of the library: by the same commands as in
# the build, whose objects are taken then. Otherwise what shows whether a consumer is configured right.
unity=''
! grep -q '^CMAKE_UNITY_BUILD:[A-Z]*=ON' "$build/CMakeCache.txt" || unity=ON
sources=(-DTAUT_SOURCE="$source" -DCMAKE_CXX_FLAGS="$flags" -DTAUT_COLD_FLAGS="$cold_flags" -DTAUT_WERROR=ON
  -DCMAKE_UNITY_BUILD="$unity" -DCMAKE_CXX_COMPILER_LAUNCHER="/usr/bin/python3;$source/tests/consumer/same_object.py;$build")
if [ -n "$unity" ]; then
  consumer sources "${sources[@]}"
else
  configured sources "${sources[@]}"
  logged sources cmake --build "$work/sources" --target hello_object plugin_object
  inherits_nothing "$work/sources"
fi
echo "all well"
