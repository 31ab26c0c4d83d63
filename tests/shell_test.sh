#!/usr/bin/env bash
# Completions and the manual page, in the shells and programs that read them. usage: shell_test.sh TAUT
set -uo pipefail
taut="$(realpath "$1")"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# Not grep -q below: it stops reading early, and with pipefail that is a failure of what writes.
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }
touch scene.json

# bash: what is offered after the words given, the last of which is being typed.
"$taut" completion bash >taut.bash || fail "completion bash"
offered() { # offered WORDS...
  bash --norc -c '
    source taut.bash
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    _taut
    printf "%s\n" "${COMPREPLY[@]}"' bash "$@"
}
offers() { # offers 'WORD WANTED' WORDS...
  local wanted="$1"
  shift
  offered "$@" | grep -xF -- "$wanted" >/dev/null || fail "bash does not offer $wanted after: $*"
}
offers_not() {
  local unwanted="$1"
  shift
  if offered "$@" | grep -xF -- "$unwanted" >/dev/null; then fail "bash offers $unwanted after: $*"; fi
}
offers check taut ''
offers completion taut ''
offers check taut che
offers_not draw taut che
offers --touch taut check --
offers_not --at taut check --
offers --at taut draw scene.json --
offers closed taut check --touch ''
offers_not open taut check --touch cl
offers both taut check scene.json --engine ''
offers scene.json taut check sc
touch 'my scene.json' 'a$b *.json'
offers 'my scene.json' taut check my
offers 'my scene.json' taut check scene.json my
offers 'my scene.json' taut draw scene.json -o my
offers 'a$b *.json' taut check a
offers gears taut gen ''
offers --teeth1 taut gen gears --te
offers fish taut completion ''
offers lid taut demo ''
offers_not scene.json taut demo ''
offers --force taut demo --
offers scene.json taut check ''
offers_not --touch taut check ''
offers scene.json taut import --merge-layers ''

# Every command and option that --help knows is in all of them.
commands="$("$taut" --help | sed -n '/^Subcommands/,/^$/s/^  \([a-z]\+\) .*/\1/p') completion man"
[ "$(wc -w <<<"$commands")" -ge 10 ] || fail "no commands in --help"
"$taut" completion zsh >_taut || fail "completion zsh"
"$taut" completion fish >taut.fish || fail "completion fish"
"$taut" man >taut.1 || fail "man"
for command in $commands; do
  for option in $("$taut" "$command" --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+'); do
    bash --norc -c 'source taut.bash; declare -f _taut' | grep -F -- "$option" >/dev/null || fail "bash: $command $option"
    grep -A40 "^_taut_$command()" _taut | grep -F -- "$option" >/dev/null || fail "zsh: $command $option"
    grep -F -- "from $command" taut.fish | grep -F -- "-l ${option#--}" >/dev/null || fail "fish: $command $option"
    sed 's/\\-/-/g' taut.1 | sed -n "/^\.SS taut $command/,/^\.SS taut /p" | grep -F -- "$option" >/dev/null || fail "man: $command $option"
  done
done

# The programs that read them have no complaint.
if command -v zsh >/dev/null; then
  zsh -n _taut || fail "zsh: syntax"
  zsh -f -c 'fpath=($PWD $fpath); autoload -U compinit; compinit -D -u; [[ "$_comps[taut]" = _taut ]]' || fail "zsh: compinit"
  # A tab behind what is typed, in a terminal of its own: the line must become what is wanted.
  cat >tab.zsh <<'EOF'
zmodload zsh/zpty
zpty -b shell zsh -f -i
zpty -w shell "PS1='ready> '; fpath=($PWD \$fpath); autoload -U compinit; compinit -D -u; unsetopt beep; print fin''ished"
zpty -r -m shell seen '*finished*'
zpty -w -n shell "$1"$'\t'
for tries in {1..100}; do
  while zpty -r -t shell piece; do text+="$piece"; done
  [[ "$text" = *"$2"* ]] && exit 0
  sleep 0.05
done
exit 1
EOF
  becomes() { # becomes TYPED WANTED
    timeout 30 zsh -f tab.zsh "$1" "$2" >/dev/null 2>&1 || fail "zsh: '$1' does not become '$2'"
  }
  becomes 'taut che' 'taut check'
  becomes 'taut check --touch c' '--touch closed'
  becomes 'taut check --cl' '--clearance'
  becomes 'taut check sc' 'scene.json'
  becomes 'taut gen gears --te' '--teeth'
  becomes 'taut demo li' 'taut demo lid'
else
  echo "zsh is not here: its completions were looked at, but not loaded"
fi
if command -v fish >/dev/null; then
  fish --no-execute taut.fish || fail "fish: syntax"
  HOME="$folder" fish --no-config -c 'source taut.fish; complete -C "taut check --touch c"' | grep '^closed' >/dev/null || fail "fish: --touch"
  HOME="$folder" fish --no-config -c 'source taut.fish; complete -C "taut che"' | grep '^check' >/dev/null || fail "fish: check"
  HOME="$folder" fish --no-config -c 'source taut.fish; complete -C "taut gen gears --te"' | grep '^--teeth1' >/dev/null || fail "fish: gen gears"
  HOME="$folder" fish --no-config -c 'source taut.fish; complete -C "taut demo l"' | grep '^lid' >/dev/null || fail "fish: demo"
else
  echo "fish is not here: its completions were looked at, but not loaded"
fi
if command -v groff >/dev/null; then
  [ -z "$(groff -man -ww -Tutf8 taut.1 2>&1 >taut.txt)" ] || fail "groff: warnings"
  sed 's/.\x08//g; s/\x1b\[[0-9;]*m//g' taut.txt | grep 'taut check SCENE' >/dev/null || fail "groff: synopsis"
else
  echo "groff is not here: the manual page was looked at, but not set"
fi

[ "$failures" = 0 ] && echo "all well"
exit "$((failures > 0))"
