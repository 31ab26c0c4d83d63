#!/usr/bin/env bash
# The programs for Windows, under Wine: what is not the same on all systems. usage: windows_test.sh BUILD SOURCE ZIP
# `./dev windows` runs it. Where build/release/taut is there, both must print the same bytes.
set -uo pipefail
build="$(realpath "$1")" source="$(realpath "$2")" zip="$(realpath "$3")"
export WINEPREFIX="$build/wine" WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml=' LC_ALL=C.UTF-8
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
failures=0

fail() {
  echo "FAILED: $*"
  head -c 1000 out err 2>/dev/null
  failures=$((failures + 1))
}
# run CODE PROGRAM ARGS: what it prints is in out and err.
run() {
  local code="$1" program="$2" got
  shift 2
  wine "$build/$program.exe" "$@" >out 2>err </dev/null
  got=$?
  [ "$got" = "$code" ] || fail "$program $*: exit code $got instead of $code"
}
# says 'PATTERN' FILE
says() { grep -qE -- "$1" "$2" || fail "no '$1' in $2"; }
no_return() { ! grep -q $'\r' "$1" || fail "a carriage return in $1"; }

run 0 taut --version
says '^taut [0-9.]+$' out
no_return out
run 2 taut chekc
says 'did you mean `taut check`' err

# That of mingw-w64 is not rounded as IEEE says.
if x86_64-w64-mingw32-nm -u "$build/libtaut.a" | grep -qw sqrt; then fail "the library calls sqrt()"; fi

# The same answers and the same bytes as here.
native="$source/build/release/taut"
[ -x "$native" ] || echo "no build/release/taut to compare with: skipped"
for scene in "$source"/examples/*.json; do
  [[ "$scene" != *.answer.json ]] || continue
  wine "$build/taut.exe" check --json "$scene" >out 2>err </dev/null
  code=$?
  no_return out
  [ -x "$native" ] || continue
  "$native" check --json "$scene" >wanted 2>/dev/null
  [ $? = "$code" ] || fail "check $scene: exit code $code"
  cmp -s out wanted || fail "check $scene: other bytes"
done

# A file is replaced, also by itself, and nothing is left beside it.
run 0 taut gen combs -n 3 -o again.json
run 0 taut gen combs -n 4 -o again.json
[ "$(ls again.json*)" = again.json ] || fail "files are left: $(ls)"
run 2 taut gen combs -n 3 -o none/a.json
says 'No such file' err
run 2 taut check .
says 'it is a folder' err
run 2 taut check NUL
says 'it is a device' err
run 0 taut gen combs -n 3 -o NUL

# Proofs, by names with characters of no code page, in both directions.
mkdir 'プルーフ é'
cp again.json 'プルーフ é/сцена.json'
run 0 taut prove 'プルーフ é/сцена.json' -o 'プルーフ é/доказательство.proof'
[ -s 'プルーフ é/доказательство.proof' ] || fail "no proof by its name"
run 0 taut-verify 'プルーフ é/сцена.json' 'プルーフ é\доказательство.proof'
says 'VALID' out
if [ -x "$native" ]; then
  "$native" prove again.json -o here.proof >wanted
  cmp -s here.proof 'プルーフ é/доказательство.proof' || fail "another proof than here"
  run 0 taut-verify again.json here.proof
fi

# Standard input and output are bytes.
wine "$build/taut.exe" check --json - <again.json >out 2>err
wine "$build/taut.exe" check --json again.json >named 2>err
[ "$(sed 's/"scene":"[^"]*"//' out)" = "$(sed 's/"scene":"[^"]*"//' named)" ] || fail "another answer from standard input"

# Files that a scene names: below its folder, however they are written.
mkdir -p world/deep
echo 'POLYGON ((0 0, 1 0, 0 1))' | tee world/deep/o.wkt >secret.wkt
for name in 'deep/o.wkt' 'deep\\o.wkt'; do
  echo '{"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"a","polygon":{"wkt":"'"$name"'"}},
    {"name":"b","polygon":[[5,5],[6,5],[5,6]],"motion":{"x":[0,1]}}]}' >world/scene.json
  run 0 taut check 'world\scene.json'
done
here="$(winepath -w secret.wkt 2>/dev/null | sed 's/\\/\\\\/g')"
for name in '..\\secret.wkt' '../secret.wkt' "$here"; do
  echo '{"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"a","polygon":{"wkt":"'"$name"'"}},
    {"name":"b","polygon":[[5,5],[6,5],[5,6]],"motion":{"x":[0,1]}}]}' >world/scene.json
  run 2 taut check world/scene.json
  says 'is not below the scene' err
done

# Answers are taken up behind the last whole line.
cp again.json second.json
run 0 taut check --json --resume answers.jsonl again.json second.json
cp answers.jsonl whole.jsonl
head -c 200 whole.jsonl >answers.jsonl
run 0 taut check --json --resume answers.jsonl again.json second.json
cmp -s answers.jsonl whole.jsonl || fail "other answers after a run was ended"

# Ctrl-C ends a run with an answer, and twice leaves nothing behind.
run 0 taut gen rotor -n 12000 -o long.json
wine "$build/taut.exe" check --engine kinetic long.json >out 2>err </dev/null &
sleep 3
kill -INT $!
wait $!
[ $? = 3 ] || fail "Ctrl-C: no answer"
says '^UNDECIDED' out
wine "$build/taut.exe" prove --engine kinetic long.json -o long.proof >out 2>err </dev/null &
sleep 3
compgen -G 'long.proof.tmp*' >/dev/null || fail "no unfinished proof"
kill -INT $!
sleep 0.1
kill -INT $! 2>/dev/null
wait $!
! compgen -G 'long.proof.tmp*' >/dev/null || fail "half a proof is left"

# The archive, as a program of others takes it.
cmake -E tar xf "$zip"
mkdir hello
cp "$source/examples/hello.cpp" hello
cat >hello/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.22)
project(hello CXX)
find_package(taut REQUIRED)
add_executable(hello hello.cpp)
target_link_libraries(hello taut::taut)
END
cmake -S hello -B hello/build -G Ninja -DCMAKE_TOOLCHAIN_FILE="$source/cmake/windows.cmake" \
  -Dtaut_DIR="$(echo "$PWD"/taut-*/lib/cmake/taut)" >out 2>err && cmake --build hello/build >out 2>err ||
  fail "the library of the archive"
wine hello/build/hello.exe >out 2>err
says '^contact at 8' out
wine taut-*/bin/taut.exe --version >out 2>err
says '^taut [0-9.]+$' out

[ "$failures" = 0 ] && echo "all well"
[ "$failures" = 0 ]
