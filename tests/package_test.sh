#!/usr/bin/env bash
# The Debian packages as a user has them: installed into a fresh Debian, and tried there. Needs root and mmdebstrap, or
# else it unpacks them into a folder and says so. usage: package_test.sh FOLDER_WITH_PACKAGES
set -euo pipefail
packages="$(realpath "$1")"
work="$(mktemp -d)"
root="$work/root"
# No chroot is left with anything mounted in it: none is mounted.
trap 'rm -rf "$work"' EXIT

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

cat >"$work/smoke.sh" <<'END'
set -eu
cd /tmp
taut --version
taut demo lid >/dev/null
code=0
taut check lid.json || code=$?
[ "$code" = 1 ] || { echo "FAILED: taut check returned $code"; exit 1; }
taut prove lid.json -o lid.proof >/dev/null || [ $? = 1 ]
taut-verify lid.json lid.proof --expect contact
printf '<svg width="4mm" viewBox="0 0 4 4"><circle id="disc" r="1"/></svg>' >disc.svg
taut import disc.svg -o disc.json
for file in /usr/share/man/man1/taut.1 /usr/share/bash-completion/completions/taut \
  /usr/share/zsh/site-functions/_taut /usr/share/fish/vendor_completions.d/taut.fish \
  /usr/include/taut/taut.hpp /usr/share/taut/integrations/inkscape/taut_contact.inx /usr/share/doc/taut/copyright; do
  [ -s "$file" ] || { echo "FAILED: $file is not installed"; exit 1; }
done
ls /usr/lib/*/libtaut.a /usr/lib/*/cmake/taut/tautConfig.cmake /usr/lib/*/pkgconfig/taut.pc >/dev/null
if [ -s /usr/share/taut/viewer.html ]; then
  taut view lid.json -o lid.html
  [ -s lid.html ]
else
  echo "the viewer's page is not in the package: it was not built (./dev web)"
fi
if [ -d /usr/lib/python3/dist-packages/taut2d ]; then
  python3 - <<'PYTHON'
import taut2d
answer = taut2d.check(taut2d.Scene.load("/tmp/lid.json"))
assert str(answer.outcome) == "contact", answer
print("python:", answer.outcome)
PYTHON
else
  echo "the Python package is not here: skipped"
fi
END

debs=("$packages"/*.deb)
[ -e "${debs[0]}" ] || fail "no packages in $packages: run ./dev package"
for deb in "${debs[@]}"; do
  dpkg-deb --info "$deb" | grep -E '^ (Package|Version|Depends|Installed-Size):'
done

if [ "$(id -u)" = 0 ] && command -v mmdebstrap >/dev/null; then
  # Through the proxy that this machine's apt has, if any.
  options=()
  while read -r option; do options+=(--aptopt="$option"); done < <(apt-config dump | grep -i '^Acquire::https\?::Proxy ' || true)
  if mmdebstrap --variant=apt "${options[@]}" bookworm "$root" >"$work/mmdebstrap.log" 2>&1; then
    mkdir -p "$root/packages"
    cp "${debs[@]}" "$root/packages/"
    chroot "$root" sh -c 'apt-get update -qq && apt-get install -y -qq --no-install-recommends /packages/*.deb' \
      >"$work/install.log" 2>&1 || {
      tail -n 20 "$work/install.log" >&2
      fail "the packages cannot be installed"
    }
    cp "$work/smoke.sh" "$root/tmp/"
    # taut finds its page from where it lies itself, as /proc says. In a mount namespace, so that nothing stays mounted.
    unshare --mount sh -c 'mount -t proc proc "$1/proc" && exec chroot "$1" sh /tmp/smoke.sh' smoke "$root" ||
      fail "the installed programs"
    chroot "$root" apt-get purge -y -qq taut >/dev/null 2>&1 || fail "the package cannot be removed"
    [ ! -e "$root/usr/bin/taut" ] || fail "the package leaves files behind"
    echo "all well in a fresh Debian"
    exit 0
  fi
  tail -n 3 "$work/mmdebstrap.log" >&2
fi
echo "no fresh Debian could be made here: the packages are unpacked into a folder instead"
for deb in "${debs[@]}"; do dpkg-deb -x "$deb" "$root"; done
PATH="$root/usr/bin:$PATH" "$root/usr/bin/taut" --version || fail "taut does not start"
cd "$work"
"$root/usr/bin/taut" demo lid >/dev/null
"$root/usr/bin/taut" check lid.json || [ $? = 1 ] || fail "taut check"
PYTHONPATH="$root/usr/lib/python3/dist-packages" /usr/bin/python3 -c 'import taut2d' || fail "import taut2d"
echo "all well, unpacked only"
