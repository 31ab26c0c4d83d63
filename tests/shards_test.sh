#!/usr/bin/env bash
# Many scenes in runs that share them, and that are killed and taken up again. usage: shards_test.sh TAUT
set -uo pipefail
taut="$(realpath "$1")"
page="$(realpath "$(dirname "${BASH_SOURCE[0]}")/../docs/answers.md")"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# expect CODE 'PATTERN IN STDERR' ARGS: runs taut, which prints no answer.
expect() {
  local code="$1" err="$2" got
  shift 2
  "$taut" "$@" >out 2>err </dev/null
  got=$?
  [ "$got" = "$code" ] || fail "taut $*: exit code $got instead of $code: $(head -c 300 err)"
  [ ! -s out ] || fail "taut $*: unexpected output: $(head -c 300 out)"
  if [ -z "$err" ]; then
    [ ! -s err ] || fail "taut $*: unexpected message: $(head -c 300 err)"
  else
    grep -qE -- "$err" err || fail "taut $*: no '$err' in: $(head -c 300 err)"
  fi
}

# A hammer that falls from some place, with a word that is no scene now and then.
scenes() { # scenes COUNT
  awk -v count="$1" 'BEGIN {
    for (i = 0; i < count; i++) {
      if (i % 97 == 96) { print "{\"format\":"; continue }
      x = i % 11 - 5
      printf "{\"format\":\"taut-scene/1\",\"id\":%d,\"time\":[0,10],\"bodies\":[{\"name\":\"anvil\",\"polygon\":" \
        "[[0,0],[4,0],[4,1],[0,1]]},{\"name\":\"hammer\",\"polygon\":[[%d,5],[%d,5],[%d,6]],\"motion\":{\"velocity\":" \
        "[0,-0.6],\"spin_deg\":%d}}]}\n", i, x, x + 2, x + 1, i % 7
    }
  }'
}
count=8000
scenes "$count" >scenes.jsonl
"$taut" check --json --lines scenes.jsonl >whole.jsonl 2>/dev/null
code=$?
[ "$(wc -l <whole.jsonl)" = "$count" ] && [ "$code" = 2 ] || fail "the scenes are not as they should be: exit code $code"
check=(check --json --lines scenes.jsonl)

# Shards have all scenes, each once: taken in turn, in the order of the scenes.
for i in 1 2 3; do "$taut" "${check[@]}" --shard "$i/3" --resume "shard-$i.jsonl" 2>/dev/null; done
paste -d '\n' shard-?.jsonl | grep . | cmp -s - whole.jsonl || fail "three shards are not all scenes"
("$taut" "${check[@]}" --shard 2/3 2>/dev/null || true) | cmp -s - shard-2.jsonl || fail "a shard to standard output differs"
("$taut" check --json --lines - --shard 2/3 <scenes.jsonl 2>/dev/null || true) | sed 's/<stdin>/scenes.jsonl/g' |
  cmp -s - shard-2.jsonl || fail "a shard of standard input differs"
head -n 1 scenes.jsonl >one.json
sed -n 2p scenes.jsonl >two.json
expect 0 '' check --json one.json two.json one.json --shard 3/4 --resume files.jsonl
[ "$(cut -c -20 files.jsonl)" = '{"scene":"one.json",' ] || fail "a shard of files: $(cat files.jsonl)"

# Cut anywhere, also within a line: the same bytes once more, and the exit code of all.
size="$(stat -c %s whole.jsonl)"
for cut in 0 1 200 65536 65537 $((size / 2)) $((size - 1)) "$size"; do
  head -c "$cut" whole.jsonl >cut.jsonl
  "$taut" "${check[@]}" --resume cut.jsonl --threads 3 >out 2>/dev/null
  [ $? = 2 ] && cmp -s cut.jsonl whole.jsonl || fail "taken up at byte $cut: another file"
  [ ! -s out ] || fail "taken up at byte $cut: something on standard output"
done
expect 2 '' "${check[@]}" --resume whole.jsonl

# Killed, again and again, in the middle of its work.
kills=0
while [ "$kills" -lt 5 ]; do
  "$taut" "${check[@]}" --resume killed.jsonl --threads 2 2>/dev/null &
  run=$!
  before="$(stat -c %s killed.jsonl 2>/dev/null || echo 0)"
  for _ in $(seq 2000); do
    now="$(stat -c %s killed.jsonl 2>/dev/null || echo 0)"
    [ "$now" -gt $((before + size / 40)) ] && break
  done
  kill -9 "$run" 2>/dev/null || break
  wait "$run" 2>/dev/null
  kills=$((kills + 1))
  # As a full disk, or a crash of the machine, would leave it.
  printf '{"scene":"scenes.jsonl:' >>killed.jsonl
done
[ "$kills" -ge 2 ] || fail "it was too fast to be killed"
"$taut" "${check[@]}" --resume killed.jsonl 2>/dev/null
cmp -s killed.jsonl whole.jsonl || fail "a run that was killed $kills times has another file"

# Also answers about a clearance, and with a report, which has the answers that were there among its cases.
clear=("${check[@]}" --clearance 0.25)
"$taut" "${clear[@]}" >clear.jsonl 2>/dev/null
head -c "$((size / 3))" clear.jsonl >cut.jsonl
"$taut" "${clear[@]}" --resume cut.jsonl --junit report.xml 2>/dev/null
cmp -s cut.jsonl clear.jsonl || fail "answers about a clearance, taken up: another file"
counts() { grep -o '<testsuite [^>]*' "$1" | grep -oE '(tests|failures|errors|skipped)="[0-9]+"'; }
"$taut" "${clear[@]}" --junit whole.xml >out 2>/dev/null
[ "$(counts report.xml)" = "$(counts whole.xml)" ] && grep -q "tests=\"$count\"" whole.xml ||
  fail "a report of answers that were taken up: $(counts report.xml), and should be $(counts whole.xml)"
grep -oE '<testcase [^>]*name="[^"]*"' whole.xml | sed 's/time="[^"]*" *//' >names
grep -oE '<testcase [^>]*name="[^"]*"' report.xml | sed 's/time="[^"]*" *//' | cmp -s - names || fail "the report has other cases"

# Ctrl-C: what is written is whole, and nothing that the signal has ended is among it.
"$taut" "${check[@]}" --resume stopped.jsonl 2>err &
run=$!
while [ ! -s stopped.jsonl ]; do :; done
kill -TERM "$run"
wait "$run"
code=$?
head -c "$(stat -c %s stopped.jsonl)" whole.jsonl | cmp -s - stopped.jsonl || fail "a run that was stopped has other answers"
if [ "$(wc -l <stopped.jsonl)" -lt "$count" ]; then
  grep -q 'stopped; the same command goes on behind the last answer in stopped.jsonl' err || fail "no word about the stop"
  [ "$code" = 3 ] || [ "$code" = 2 ] || fail "a run that was stopped: exit code $code"
fi

# What does not fit together is refused, and nothing is written.
head -n 10 whole.jsonl >other.jsonl
cp other.jsonl kept.jsonl
expect 2 'other.jsonl:1: the answer is about scenes.jsonl:1, and should be about one.json' check --json one.json --resume other.jsonl
expect 2 'other.jsonl:2: the answer is about scenes.jsonl:2, and should be about scenes.jsonl:4' "${check[@]}" --shard 1/3 --resume other.jsonl
expect 2 'other.jsonl:1: the answer has touch: "open", and should have "closed"' "${check[@]}" --touch closed --resume other.jsonl
expect 2 'other.jsonl:1: the answer has fit: none, and should have 0.25' "${check[@]}" --fit 0.25 --resume other.jsonl
expect 2 'other.jsonl:1: the answer has at_rest: none, and should have "test"' "${check[@]}" --at-rest test --resume other.jsonl
expect 2 'other.jsonl:1: the answer has pairs: first, and should have all' "${check[@]}" --pairs all --resume other.jsonl
expect 2 'other.jsonl:1: the answer has clearance: none, and should have 0.25' "${clear[@]}" --resume other.jsonl
head -n 10 clear.jsonl >other_clear.jsonl
expect 2 'other_clear.jsonl:1: the answer has clearance: 0.25, and should have none' "${check[@]}" --resume other_clear.jsonl
expect 2 'other_clear.jsonl:1: the answer has clearance: 0.25, and should have 0.5' "${check[@]}" --clearance 0.5 --resume other_clear.jsonl
head -n 3 scenes.jsonl >few.jsonl
sed 's/scenes.jsonl/few.jsonl/' whole.jsonl | head -n 5 >many.jsonl
expect 2 'many.jsonl:4: there are more answers than scenes' check --json --lines few.jsonl --resume many.jsonl
cmp -s other.jsonl kept.jsonl || fail "a file that was refused has changed"
echo 'free' >words.jsonl
expect 2 'words.jsonl:1: this is no answer of' "${check[@]}" --resume words.jsonl
expect 2 'answers are taken up line by line.*' check --lines scenes.jsonl --resume x.jsonl
expect 2 'hint: add --json' check --lines scenes.jsonl --resume x.jsonl
[ ! -e x.jsonl ] || fail "a file was made for a wrong command line"
expect 2 'folder: cannot open it: Is a directory' "${check[@]}" --resume "$(mkdir -p folder && echo folder)"
mkfifo pipe
expect 2 'pipe: it is not a regular file' "${check[@]}" --resume pipe
for wrong in 0/3 4/3 1 1/0 a/b 1/3x -1/3 1/ /3 '1 / 3'; do
  expect 2 '--shard: ".*" is no shard' "${check[@]}" "--shard=$wrong" --resume x.jsonl
done
if command -v flock >/dev/null; then
  expect 0 '' check --json --lines few.jsonl --resume taken.jsonl
  flock taken.jsonl "$taut" check --json --lines few.jsonl --resume taken.jsonl 2>err
  grep -q 'taken.jsonl: another process writes answers into it' err || fail "two processes write into one file: $(cat err)"
fi
# A file that may not grow; the signal is ignored, as a full disk has none.
(trap '' XFSZ && ulimit -f 40 && "$taut" "${check[@]}" --resume limited.jsonl) 2>err
grep -q 'limited.jsonl: cannot write an answer: File too large' err || fail "a full disk: $(tail -n 2 err)"
"$taut" "${check[@]}" --resume limited.jsonl 2>/dev/null
cmp -s limited.jsonl whole.jsonl || fail "a disk that was full has left another file"

# The script for Slurm of docs/answers.md, as the tasks of an array run it.
mkdir -p programs slurm
ln -s "$taut" programs/taut
sed -n '/^#!\/bin\/bash$/,/^\$ sbatch/p' "$page" | grep -v '^\$ sbatch' >slurm/check.slurm
grep -v '"format":$' scenes.jsonl >slurm/scenes.jsonl
(cd slurm && "$taut" check --json --lines scenes.jsonl >whole.jsonl)
for task in 1 2 3 4; do
  (cd slurm && SLURM_ARRAY_TASK_ID="$task" SLURM_ARRAY_TASK_COUNT=4 SLURM_CPUS_PER_TASK=1 PATH="$folder/programs:$PATH" \
    bash check.slurm) || fail "the script for Slurm: task $task has failed"
done
(cd slurm && paste -d '\n' answers-?.jsonl | grep . | cmp -s - whole.jsonl) || fail "the script for Slurm: other answers"

# The recipe for GNU parallel.
if command -v parallel >/dev/null && parallel --version 2>/dev/null | grep -q '^GNU parallel'; then
  export HOME="$folder" taut
  mkdir -p .parallel && touch .parallel/will-cite
  parallel -j 2 "$taut" check --json --lines scenes.jsonl --shard {}/5 --resume answers-{}.jsonl --threads 1 ::: 1 2 3 4 5 2>/dev/null
  paste -d '\n' answers-?.jsonl | grep . | cmp -s - whole.jsonl || fail "GNU parallel: other answers"
else
  echo "skipped: GNU parallel is not installed (on Debian: parallel), and its recipe was not run"
fi

[ "$failures" = 0 ] && echo "all passed"
exit "$((failures > 0))"
