#!/usr/bin/env bash
# The taut command as scripts see it: exit codes, what goes to stdout and what to stderr. usage: cli_test.sh TAUT [SHARE]
# SHARE divides the size of the largest scenes, where taut is watched by sanitizers; by default 1, or 10 where TAUT_EFFORT
# says `tenth`.
set -uo pipefail
usual_share=1
[ "${TAUT_EFFORT:-}" = tenth ] && usual_share=10
taut="$(realpath "$1")" share="${2:-$usual_share}"
examples="$(realpath "$(dirname "$0")/../examples")"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
failures=0

# expect CODE 'PATTERN IN STDOUT' 'PATTERN IN STDERR' ARGS: runs taut; an empty pattern means no output at all.
expect() {
  local code="$1" out="$2" err="$3" got problem=""
  shift 3
  "$taut" "$@" >out 2>err </dev/null
  got=$?
  [ "$got" = "$code" ] || problem+=" exit code $got instead of $code;"
  if [ -z "$out" ]; then
    [ -s out ] && problem+=" unexpected stdout;"
  else
    grep -qE -- "$out" out || problem+=" no '$out' on stdout;"
  fi
  if [ -z "$err" ]; then
    [ -s err ] && problem+=" unexpected stderr;"
  else
    grep -qE -- "$err" err || problem+=" no '$err' on stderr;"
  fi
  if [ -n "$problem" ]; then
    echo "FAILED: taut $*:$problem"
    head -c 1000 out
    head -c 1000 err
    failures=$((failures + 1))
  fi
}

# Looked at when all are there: a Python that starts takes longer than most of what is tested here.
is_json_lines() { cat out >>all.jsonl; }
all_are_json_lines() {
  command -v python3 >/dev/null || return
  python3 - all.jsonl <<'EOF' && return
import json, sys
for line in open(sys.argv[1], encoding="utf-8"):
    try:
        json.loads(line)
    except ValueError as wrong:
        sys.exit(f"FAILED: not a JSON line: {line[:1000]}{wrong}")
EOF
  failures=$((failures + 1))
}

scene() { # scene NAME MOTION END: a hammer over an anvil
  echo '{"format":"taut-scene/1","time":[0,'"$3"'],"bodies":[
    {"name":"anvil","polygon":[[0,0],[4,0],[4,1],[0,1]]},
    {"name":"hammer","polygon":[[1,5],[3,5],[2,6]],"motion":'"$2"'}]}' >"$1"
}
scene hit.json '{"y":[0,-0.5]}' 10
scene free.json '{"y":[0,0.5]}' 10
scene touch.json '{"y":[0,-0.5]}' 8
scene overlap.json '{"y":[-4.5]}' 10

# Hostile sizes and numbers.
polygon_scene() { # polygon_scene NAME AWK_PROGRAM: a first body with the vertices that awk prints, one "x,y" a line
  { printf '{"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"big","polygon":['
    awk "BEGIN { $2 }" | sed 's/.*/[&]/' | paste -sd,
    printf ']},{"name":"small","polygon":[[-9,-9],[-8,-9],[-8,-8]]}]}'; } >"$1"
}
# 100 MB: the upper side of a ring is traced twice.
polygon_scene huge.json "n = 3300000 / $share; for (i = 0; i < n; i++) printf \"%.14f,%.14f\\n\", cos(6.6 * i / n), sin(6.6 * i / n)"
[ "$(stat -c %s huge.json)" -gt $((100000000 / share)) ] || { echo "FAILED: huge.json is too small"; failures=$((failures + 1)); }
expect 2 '' 'huge.json: big: the boundary is not simple' check huge.json
polygon_scene million.json "n = 1000000 / $share; for (i = 0; i < n; i++) print i \",\" (i % 2); print n / 2 + 0.5 \",-1\"; print n / 2 + 0.5 \",3\""
expect 2 '' 'million.json: big: the boundary is not simple: edges [0-9]+-[0-9]+ and [0-9]+-[0-9]+ (cross|touch)' check million.json
polygon_scene range.json 'print "0,0"; print "1e308,0"; print "0,1e308"'
expect 2 '' 'range.json: big: .*1e\+308.*(2\^400|magnitude)' check range.json
polygon_scene infinite.json 'print "0,0"; print "1e999,0"; print "0,1"'
expect 2 '' 'infinite.json:[0-9]+:[0-9]+: .*1e999' check infinite.json
rm -f huge.json million.json

# Help and usage.
expect 0 'Subcommands' '' --help
expect 0 'Exit codes' '' --help
expect 0 '^taut [0-9]' '' --version
for command in demo import check clearance intervals range separate mechanism envelope path cells swept follow trace prove verify draw view separator flatten gen schema completion man; do expect 0 'Example' '' "$command" --help; done
[ "$("$taut" --help | wc -l)" -le 30 ] || { echo "FAILED: --help does not fit a screen"; failures=$((failures + 1)); }
expect 2 '' 'what is wanted is missing'
expect 2 '' 'unknown command "chek"' chek x
expect 2 '' 'did you mean `taut check`' chek x
expect 2 '' 'SCENE' check
expect 2 '' '--nonsense' check --nonsense hit.json
expect 2 '' 'ajar' check --touch ajar hit.json
expect 2 '' '--max-seconds' check --max-seconds -1 hit.json

# Drawings.
cat >plate.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="20mm" viewBox="0 0 40 40">
  <g id="plate"><path d="M0 0H40V40H0Z M10 10a5 5 0 1 0 10 0 5 5 0 1 0-10 0Z"/><text>a</text></g>
</svg>
END
expect 0 '"holes":\[\[' '2 curves as [0-9]+ chords.*0.01|skipped: <text> at plate.svg:2' import plate.svg
expect 0 '"name":"plate","file":"plate.svg","parts":1,"holes":1' '' import plate.svg --json -o plate.json
is_json_lines
# Curves as they are: a corner in the outline's own direction, y upwards, and what is none is named.
cat >round.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><path id="cam" d="M1 1 H5 A2 2 0 0 1 5 5 Q3 6 1 5 Z"/><circle id="roller" cx="9" cy="3" r="0.5"/></svg>
END
expect 0 '"path":"M 1 -1 L 5 -1 A 2 2 0 0 0 7 -3 A 2 2 0 0 0 5 -5 Q 3 -6 1 -5 L 1 -1 Z"' '7 segments of 3 curves kept as they are' import --curves round.svg
expect 0 '' 'body roller: 1 part, 0 holes' import --curves round.svg -o round.json
# The cam ends at x = 7, the roller begins at 8.5, and both at y = -3.
expect 0 '^CLEARANCE  \[?1\.(4999999|5000000)' '' clearance round.json --tolerance 1e-9
expect 0 'A 6 6 0 0 1 120 6 .*A 4 4 0 0 1' '100 segments of 48 curves kept as they are' import --curves "$examples/curves/hinge.dxf"
expect 2 '' '--tolerance: 0 is not a positive number' import plate.svg --tolerance 0
expect 2 '' '--output|-o' import plate.svg --json
# Lines as people draw them: what stays open is an error, in the picture, and may be closed or left out.
cat >open.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="40mm" viewBox="0 0 40 40"><g id="cut" fill="none" stroke="black">
<path d="M0 0H40V40H0V0.5"/><circle cx="20" cy="20" r="5"/><path d="M30 30h5"/></g><g id="mark" fill="none" stroke="red"><circle cx="5" cy="5" r="2"/></g></svg>
END
expect 2 '' 'open.svg:2:1: an outline stays open, with a gap of 0.5 from \(0' import open.svg --svg open_report.svg
grep -q '#d62828' open_report.svg || { echo "FAILED: the picture shows nothing open"; failures=$((failures + 1)); }
expect 2 '' 'hint: close it by straight lines with --open close, or with --join 0.505' import open.svg
expect 0 '"holes":\[\[' 'gap: 0.5 wide, from \(0, ' import open.svg --join 0.6
expect 0 '"holes":\[\[' 'layer mark: 1 contour is a hole in material of layer cut' import open.svg --join 0.6
expect 0 '"holes":\[\[' 'open: line at open.svg:2:60, layer cut, from \(30, -30\) to \(35, -30\)$' import open.svg --open close
expect 0 '"holes":\[\[' 'closed: an outline at open.svg:2:1, layer cut by 1 straight line, 0.5 in all' import open.svg --open close
expect 0 '"parts":2,"holes":0' '' import open.svg --open skip --json -o open.json
is_json_lines
expect 0 '"parts":2,"holes":1' '' import open.svg --open close --by layer --json -o open.json
expect 0 '"parts":1,"holes":0' '' import open.svg --layer mark --json -o open.json
expect 0 '"parts":1,"holes":2,"area":1509\.' '' import open.svg --open close --json -o open.json --merge-layers
expect 0 '"parts":1,"holes":2,"area":1509\.' '' import --merge-layers open.svg --open close --json -o open.json
expect 0 '"parts":1,"holes":2,"area":1509\.' '' import --merge-layers=cut,mark open.svg --open close --json -o open.json
expect 2 '' '--layer: open.svg has no layer "marks"' import open.svg --layer marks
expect 2 '' 'its layers are: cut, mark' import open.svg --layer marks
expect 2 '' 'did you mean "mark"' import open.svg --layer marc
# Layers with heights: what lies on another layer is no hole in it, and the two never meet.
expect 0 '"z":\[0,3\]' 'area 12.* x 4, z 3\.\.6|area [0-9.]+, 4 x 4, z 3\.\.6' import open.svg --open close --layer cut=0:3 --layer mark=3:6
expect 0 '"z":\[\[null,3\]\]' '' import open.svg --open close --layer cut=:3 --layer mark=3: --json -o open.json
is_json_lines
expect 2 'the only pair is on different layers' '' check open.json
expect 2 '' '--layer: layer "mark" runs from 3 to 0' import open.svg --layer mark=3:0
expect 2 '' 'plate.svg:2:[0-9]+: <text> is text' import plate.svg --strict
expect 2 '' '--by' import plate.svg --by size
cat > keyway.svg <<'EOF'
<svg fill="none" stroke="black"><g><circle cx="0" cy="0" r="20"/><rect x="-2" y="-30" width="4" height="20"/></g></svg>
EOF
expect 2 '' 'keyway.svg:1:66: the closed contour at keyway.svg:1:66 \(area 80\) crosses that at keyway.svg:1:36 \(area 1255' import keyway.svg
expect 2 '' 'say --crossing subtract, if the smaller one is to be cut out' import keyway.svg
expect 0 '"parts":1,"holes":0,"area":1215' '' import keyway.svg --crossing subtract --json -o keyway.json
expect 0 '"parts":1,"holes":0,"area":1295' '' import keyway.svg --crossing union --json -o keyway.json
expect 0 '' 'note: the closed contour at .*they divide each other into parts' import keyway.svg --crossing parts -o keyway.json
expect 2 '' '--crossing' import keyway.svg --crossing cut
touch plate.png plate.abc
expect 2 '' 'plate.abc: the ending of the file' import plate.abc
expect 2 '' 'plate.png: the file is an image' import plate.png
expect 2 '' 'taut import map.yaml' import plate.png
expect 2 '' '--unit: "inch" is no unit of length' import plate.svg --unit inch
expect 0 '' "taken for in .--unit." import round.svg --unit in -o unit.json
gzip -c plate.svg >plate.svgz
expect 0 '"holes":\[\[' 'plate.svgz: SVG' import plate.svgz
# What is there already is not of the run that failed.
echo old >old.json
expect 2 '' 'no scene was written; old.json is an older file, left as it was' import open.svg -o old.json
grep -q old old.json || { echo "FAILED: a file was written in spite of an error"; failures=$((failures + 1)); }
expect 2 '' 'missing.svg' import missing.svg

# Robots' maps, and cells.
printf 'P2 3 3 255  0 0 0  0 254 0  0 0 0\n' >room.pgm
printf 'image: room.pgm\nresolution: 2\norigin: [-3, -3, 0]\n' >room.yaml
expect 0 '"holes":\[\[' 'room.yaml: occupancy grid, units: 3 x 3 cells of 2' import room.yaml
# The same as PNG: 3 x 3, grey, of 8 bits.
printf 'iVBORw0KGgoAAAANSUhEUgAAAAMAAAADCAAAAABzQ+pjAAAADklEQVR42mNgAIF/YBIABgAA/wMmOiYAAAAASUVORK5CYII=' | base64 -d >room.png
sed 's/room.pgm/room.png/' room.yaml >room_png.yaml
expect 0 '"holes":\[\[' 'body cells 1: 1 part, 1 hole, 8 vertices, area 32' import room_png.yaml
head -c 50 room.png >cut.png
sed 's/room.pgm/cut.png/' room.yaml >cut_png.yaml
expect 2 '' 'cut.png: the PNG cannot be read' import cut_png.yaml
printf 'image: room.pgm\nresolution: 0\n' >bad.yaml
expect 2 '' "bad.yaml: .origin. is missing" import bad.yaml
printf 'image: nowhere.pgm\nresolution: 1\norigin: [0, 0, 0]\n' >bad.yaml
expect 2 '' 'nowhere.pgm: cannot open' import bad.yaml
cat >primitive.json <<'END'
{"format": "taut-scene/1", "time": [0, 1], "bodies": [
  {"name": "wall", "polygon": [[9, 9], [10, 9], [10, 10]]},
  {"name": "cart", "polygon": [[0, 0], [1, 0], [1, 1], [0, 1]], "motion": {"velocity": [0.5, 0]}}]}
END
expect 0 '^CELLS  cart   9 of 1, columns -1 to 1, rows -1 to 1$' '' cells primitive.json --resolution 1
expect 0 '^{"body":"cart","resolution":2,"origin":\[-0.5,-0.5\],"cells":\[\[0,0\],\[1,0\]\]}$' '' cells --json primitive.json --resolution 2 --origin-x -0.5 --origin-y -0.5
expect 0 '^CELLS  wall' '' cells primitive.json --resolution 1 --body wall --pgm cells.pgm
expect 0 '"name":"cells 1","file":"cells.yaml"' '' import cells.yaml --json -o cells.json
expect 2 '' '--body: there is no body "car"' cells primitive.json --resolution 1 --body car
expect 2 '' 'the resolution is not a positive number' cells primitive.json --resolution 0
expect 3 '' 'the time limit was reached' cells primitive.json --resolution 0.05 --max-seconds 0

# The region that a body passes over, in every form.
expect 0 '^SWEPT  cart passes over' '' swept primitive.json -o way.svg
for form in dxf wkt geojson json; do expect 0 'at most 0.1 too large' '' swept primitive.json --tolerance 0.1 -o "way.$form"; done
grep -q 'fill-rule="evenodd"' way.svg && grep -q '^POLYLINE' way.dxf && grep -q '^MULTIPOLYGON ((' way.wkt &&
  grep -q '"type":"Feature"' way.geojson && grep -q '^{"body":"cart","tolerance":0.1' way.json || { echo "FAILED: files of swept"; failures=$((failures + 1)); }
expect 0 '"name":"SWEPT"' '1 part, 0 holes' import way.dxf
expect 0 '^{"body":"wall"' '' swept primitive.json --body wall --json
cat >valve.json <<'EOF2'
{"format": "taut-scene/1", "time": [0, 1], "bodies": [
 {"name": "cam", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": {"velocity": [0, 0], "spin_deg": 90}},
 {"name": "plate", "polygon": [[-3, 1], [3, 1], [3, 1.5], [-3, 1.5]]}]}
EOF2
expect 0 '^LIFTED  plate' '' follow valve.json --body plate --reach 2 --csv lift.csv
expect 0 'at 40 of 40 instants' '' follow valve.json --body plate --reach 2 --instants 40
expect 0 '"vertex":{"body":"cam","index":2}' '' follow valve.json --body plate --reach 2 --json
sed 's/\[-3, 1\], \[3, 1\], \[3, 1.5\], \[-3, 1.5\]/[-3, 3], [3, 3], [3, 4], [-3, 4]/' valve.json >above.json
expect 0 '^NOT LIFTED  plate' '' follow above.json --body plate --reach 2
expect 0 'CONTACTS  1 stretch, ' '' follow above.json --body plate --reach 2 --contacts
[ "$(wc -l <lift.csv)" -eq 361 ] || { echo "FAILED: the table of follow"; failures=$((failures + 1)); }
expect 2 '' 'give a lift at which it is free at all times' follow valve.json --body plate --reach 0.1
expect 2 '' 'instants: they are not' follow valve.json --body plate --reach 2 --instants 0
expect 2 '' '--body: there is no body "late"' follow valve.json --body late --reach 2
expect 2 '' '^hint: did you mean "plate". the scene has "cam", "plate"' follow valve.json --body plat --reach 2
expect 2 '' '^hint: --reach X: the lift at which it clears' follow valve.json --body plate
expect 0 'CONTACTS  1 stretch, changes known to 1e-06 of the time' '' follow valve.json --body plate --reach 2 --contacts --tolerance 1e-6
expect 0 '"state":"carried","lift":.*"touching":.."vertex":{"body":"cam","index":2}' '' follow valve.json --body plate --reach 2 --contacts --json
expect 0 ',carried,.*,0,0,cam 2 on plate 0$' '' follow valve.json --body plate --reach 2 --contacts-csv -
expect 2 '' 'tolerance: it is not' follow valve.json --body plate --reach 2 --contacts --tolerance 2
expect 2 '' 'taut flatten' follow "$examples/curves/cam.json" --body roller --reach 20 --contacts
expect 3 'UNDECIDED' '' follow valve.json --body plate --reach 2 --contacts --max-seconds 0
expect 3 'undecided on .0, 1.: the time limit was reached' '' follow valve.json --body plate --reach 2 --max-seconds 0
expect 2 '' 'way.pdf: the name does not say which form is wanted' swept primitive.json -o way.pdf
expect 2 '' '--body: there is no body "car"' swept primitive.json --body car
expect 2 '' 'the tolerance is too small' swept primitive.json --tolerance 1e-12
expect 2 '' "--tolerance: '0' is not more than 0" swept primitive.json --tolerance 0
expect 3 '' 'the time limit was reached' swept primitive.json --max-seconds 0
expect 2 '' "--tolerance: '-1' is not more than 0" swept primitive.json --tolerance -1
expect 2 '' 'resolution' cells primitive.json
sed 's/V40H0Z/V40H0X/' plate.svg >broken.svg
expect 2 '' 'broken.svg:2:17: this is no command of a path, at character 13' import broken.svg
echo '<svg><text>a</text></svg>' >empty.svg
echo '(kicad_pcb (gr_rect (start 0 0) (end 9 9) (layer Edge.Cuts)) (via (at 3 3) (drill 0.4)) (footprint H (at 6 6) (pad "" np_thru_hole circle (at 0 0) (drill 3))))' >drilled.kicad_pcb
expect 0 '"polygon"' 'note: drills are no holes of the board: 1 of pads and 1 of vias, 0.4 to 3 wide' import drilled.kicad_pcb
expect 0 '"parts":1,"holes":1' '' import drilled.kicad_pcb --drills 2 --json -o drilled.json
expect 0 '"parts":1,"holes":2' '' import drilled.kicad_pcb --drills 0 --json -o drilled.json
expect 2 '' '--drills: -1 is not a sensible number' import drilled.kicad_pcb --drills -1
echo '<svg width="20mm" viewBox="0 0 20 20"><rect width="9" height="9" fill="none"/></svg>' >unseen.svg
expect 0 '' 'its one shape is read as outlines' import unseen.svg -o unseen.json
echo '<svg height="20MM" viewBox="0 0 10 10"><style>g>.a{fill:none} .a:nth-child(1){stroke:red}</style><g><rect class="a" width="4" height="4"/></g></svg>' >rules.svg
expect 2 '' 'rules.svg:1:[0-9]+: the rule ".a:nth-child\(1\)" has ":nth-child\(1\)", which is not read' import rules.svg
expect 2 '' 'hint: style the elements by their classes or ids, or leave it as it is with --open skip' import rules.svg
sed -i 's/:nth-child(1)//' rules.svg
expect 0 '\[8, -8\]|8,-8' 'units: mm \(2 mm for each' import rules.svg
expect 2 '' 'empty.svg: nothing in the file encloses an area; skipped: <text>' import empty.svg

# Answers.
expect 1 '^CONTACT  anvil x hammer   t = \[?(8|7\.99999)' '' check hit.json
expect 1 'proved free on \[0, ' '' check hit.json
expect 0 '^FREE  anvil x hammer' '' check free.json
expect 1 '^OVERLAP AT START  anvil x hammer' '' check overlap.json
expect 1 'the motion starts: \(2, 0\.53125\) is inside both' '' check overlap.json
expect 1 '"outcome":"contact","t":\[.*"engine":"spacetime".*"touch":"open"' '' check --json hit.json
is_json_lines
expect 0 '"outcome":"free"' '' check --json free.json
expect 1 '"outcome":"overlap_at_start","overlap":\{"point":\[2,0\.53125\]\}' '' check --json overlap.json
sed 's/"time"/"id": {"job": [1, 2.50]}, "time"/' hit.json >with_id.json
expect 1 '^\{"id":\{"job":\[1,2\.50\]\},"outcome":"contact"' '' check --json with_id.json
tr -d '\n' <with_id.json >with_id.jsonl
expect 1 '^\{"scene":"with_id.jsonl:1","id":\{"job":\[1,2\.50\]\},"outcome":"contact"' '' check --json --lines with_id.jsonl
sed 's/"bodies":\[/&{"name":"third","polygon":[[9,9],[10,9],[9,10]]},/' hit.json >three.json
expect 1 'CONTACT  anvil x hammer' '' check three.json
expect 1 'proof in three.proof' '' prove three.json -o three.proof
expect 0 'separations' '' verify three.json three.proof --expect contact
expect 0 '"outcome":"free"' '' check --json --touch open touch.json
expect 1 '"outcome":"contact".*"touch":"closed"' '' check --json --touch closed touch.json
expect 1 '"timing":\{"read":' '' check --json --timing hit.json
expect 1 'read .*, build .*, run ' '' check --timing hit.json
expect 3 '^UNDECIDED  anvil x hammer' '' check --max-events 0 hit.json
expect 3 '"outcome":"undecided","free_until":' '' check --json --max-events 0 hit.json
for engine in kinetic spacetime both either; do
  answers=$engine
  [ $engine != either ] || answers='(kinetic|spacetime)'
  expect 1 '"outcome":"contact","t":\[(8|7\.99999).*"engine":"'"$answers"'"' '' check --json --engine $engine hit.json
  expect 0 '^FREE' '' check --engine $engine free.json
  expect 1 '^OVERLAP AT START' '' check --engine $engine overlap.json
  expect 1 '^CONTACT' '' check --engine $engine --touch closed touch.json
  expect 3 'the time limit was reached' '' check --engine $engine --max-seconds 0 free.json
done
expect 2 '' '--engine' check --engine steam hit.json
"$taut" check --json hit.json >one
"$taut" check --json - <hit.json >two
cmp -s one two || { echo "FAILED: the same scene gives different bytes"; failures=$((failures + 1)); }

# Curves and charts.
# Instants far from 0 are told apart.
echo '{"format":"taut-scene/1","time":[1790000000,1790000010],"bodies":[{"name":"a","polygon":[[0,0],[1,0],[0,1]]},{"name":"b","polygon":[[3,3],[4,3],[3,4]],"motion":{"keyframes":[{"t":1790000000,"x":0,"y":0},{"t":1790000006,"x":-1,"y":-1},{"t":1790000010,"x":1,"y":1}]}}]}' >epoch.json
expect 0 'at t = 1790000006' '' clearance epoch.json
expect 0 '^ +1790000002\.5 ' '' clearance --profile 5 epoch.json
expect 1 '^PROFILE  anvil x hammer   greatest ' '' clearance --profile 5 hit.json
expect 1 '"largest":\{"lo":[^,]*,"hi":[^,]*,"t":0,"settled":true\},"instants":\[\[0,' '' clearance --profile 5 --json hit.json
is_json_lines
expect 1 '^anvil,hammer,0,' '' clearance --profile 5 --csv - hit.json
[ "$(wc -l <out)" = 6 ] || { echo "FAILED: a profile of 5 instants has other lines"; failures=$((failures + 1)); }
expect 1 '^PROFILE' '' clearance --profile 5 --svg profile.svg hit.json
grep -q 'class="distance"' profile.svg || { echo "FAILED: profile.svg"; failures=$((failures + 1)); }
expect 1 'CONTACT' 'note: --time-tolerance changes nothing' check hit.json --time-tolerance 1e-6
expect 2 '' '--profile' clearance --csv - hit.json
expect 2 '' '--profile' clearance --profile 1 hit.json
expect 2 '' 'cannot both go to standard output' clearance --profile 5 --csv - --svg - hit.json
expect 3 '^UNDECIDED' '' clearance --profile 5 --max-seconds 0 hit.json
expect 0 '<g class="distance">.*stroke="#6a1fb5"' '' clearance --svg - free.json
expect 0 'anvil x hammer: 4<' '' clearance --svg - free.json
expect 1 'the least distance, at t = 8, is 0: anvil x hammer' '' clearance --svg - hit.json
expect 0 '^CLEARANCE' '' clearance --svg closest.svg free.json
grep -q 'class="distance"' closest.svg || { echo "FAILED: no closest points in the picture"; failures=$((failures + 1)); }
expect 1 'closer than 1 at t = 6' '' check --clearance 1 --svg - hit.json
expect 1 '<g class="distance">.*stroke="#6a1fb5"' '' check --clearance 1 --svg - hit.json
expect 0 'all keep 1 on \[0, 10\]' '' check --clearance 1 --svg - free.json
expect 1 'closer than 5 at t = 0' '' check --clearance 5 --svg - hit.json
expect 1 '^CLOSER AT START  anvil x hammer   closer than 50 at t = 0' '' check --clearance 50 hit.json
expect 1 '^OVERLAP AT START  anvil x hammer   t = 0' '' check --clearance 50 overlap.json
expect 1 '"outcome":"closer_at_start","clearance":50' '' check --clearance 50 --json hit.json
expect 1 '^ +closer_at_start +anvil x hammer   .* apart' '' check --clearance 50 --pairs all hit.json
expect 1 'no proof was written' '' prove --clearance 50 hit.json -o far.proof
expect 1 'overlap: anvil x hammer' '' check --clearance 1 --svg - overlap.json
expect 2 '' 'clearance' check --svg - hit.json
sed 's/}$/,"clearances":[{"pair":["anvil","*"],"margin":[0.5,0.25]}]}/' hit.json >margins.json
expect 1 '^CONTACT  anvil x hammer   closer than 1\.66666667 at t = 4\.6666' '' check --clearance 9 margins.json
expect 1 '"margin":\[0.5,0.25\],"margin_at":1\.66666' '' check --clearance 9 --json margins.json
expect 1 'closer than 1\.666667 at t = 4\.6666' '' check --clearance 9 --svg - margins.json
expect 1 '^CONTACT  anvil x hammer   t = ' '' check margins.json
sed 's/\[0.5,0.25\]/[0.5,0.125],"origin":10/' margins.json >kept.json
expect 2 '' 'clearances\[0\]: the margin is -0\.75 at t = 0' check --clearance 9 kept.json
sed 's/"time":\[0,10\]/"time":[0,2]/; s/0.25\]/0]/' margins.json >kept.json
expect 0 '^FREE  anvil x hammer   all keep their clearances on \[0, 2\]' '' check --clearance 9 kept.json
expect 2 '' 'a log is about one clearance' prove --clearance 9 kept.json -o kept.proof
sed 's/"anvil","\*"/"anvil","anvl"/' margins.json >wrong.json
expect 2 '' 'there is no body "anvl"' check --clearance 9 wrong.json
expect 2 '' 'hint: did you mean "anvil"?' check --clearance 9 wrong.json
sed 's/"anvl"/"ANVIL"/' wrong.json >capitals.json
expect 2 '' 'hint: did you mean "anvil"?' check --clearance 9 capitals.json
expect 0 '<g class="rose".*<path class="free"' '' separate --svg - hit.json
expect 0 '"outcome":"free"' '' separate --json --svg rose.svg hit.json
grep -q 'class="rose"' rose.svg || { echo "FAILED: no rose in the picture"; failures=$((failures + 1)); }
expect 1 'class="goal"' '' path "$examples/paths/reach.json" --map -
expect 2 '' 'a picture has two directions' path "$examples/paths/piano.json" --map far.svg -o far.json
[ ! -e far.json ] || { echo "FAILED: path searched before it refused a map"; failures=$((failures + 1)); }
echo old >far.json
expect 1 '^NONE' 'no scene was written; far.json is an older file' path "$examples/paths/piano_long.json" -o far.json
expect 1 '^LOCKED' 'no scene was written' separate --turns "$examples/jigsaw_caught.json" -o none.json
expect 1 'overlap: anvil x hammer' '' separate --svg - overlap.json
expect 0 '"ways":\[\{"body":"hammer"' '' separate --turns --json hit.json
expect 0 '^FREE  anvil x hammer' '' separate --turns hit.json -o leaving.json
expect 0 '^FREE  anvil x hammer' '' check leaving.json
expect 2 '' 'add --turns' separate hit.json -o leaving.json
expect 2 '' 'search for ways with turns' separate hit.json --tolerance 0.1
expect 0 'class="free".*' '' range --from 1 --svg - hit.json
expect 0 '>8: anvil x hammer<' '' range --from 1 --svg - hit.json
expect 0 '>the start<' '' range --from 1 --svg - hit.json
expect 2 '' 'from: anvil and hammer touch at that instant' range --from 8 --touch closed hit.json
expect 2 '' 'from: anvil and hammer overlap at that instant' range --from 8.25 --touch closed hit.json
# Bodies with parts on several layers are counted once, and features are named with their part and hole.
echo '{"format":"taut-scene/1","time":[0,6],"bodies":[
  {"name":"rack","parts":[{"outline":[[3,0],[4,0],[4,1],[3,1]],"z":[0,1]},
                          {"outline":[[6,0],[9,0],[9,4],[6,4]],"holes":[[[7,0.5],[8,0.5],[8,3],[7,3]]],"z":[1,3]}]},
  {"name":"cart","polygon":[[0,0],[1,0],[1,1],[0,1]],"z":[0,2],"motion":{"velocity":[1,0]}}]}' >rack.json
expect 1 'enter: vertex 0 of part 1 of rack and edge 1-2 of cart' '' intervals rack.json
expect 1 '"coverage":\{"pairs":1,"tested":1,"apart":0,.*"not_reached":0\}' '' intervals --json rack.json
sed 's/"time":\[0,6\]/"time":[0,1]/' rack.json >rack_apart.json
expect 0 'edge 3-0 of part 0 of rack' '' clearance rack_apart.json
# What was not tested is in the second line, whatever else there is to say.
echo '{"format":"taut-scene/1","time":[0,4],"bodies":[
  {"name":"disc","polygon":{"path":"M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"}},
  {"name":"roller","polygon":{"path":"M9 1 A2 2 0 0 1 5 1 A2 2 0 0 1 9 1 Z"},"motion":{"velocity":[-0.5,0.25],"spin_deg":20}},
  {"name":"post","polygon":[[-1,0.5],[0,0.5],[0,3],[-1,3]]}]}' >rollers.json
expect 0 'the greatest distance of curves' '' clearance --profile 3 rollers.json
sed -n 2p out | grep -q 'NOT TESTED: 1 at rest' || { echo "FAILED: the second line of a profile"; failures=$((failures + 1)); }
expect 1 'class="overlap".*' '' intervals --svg - hit.json
expect 3 'class="undecided"' '' intervals --svg - --max-seconds 0 hit.json

# An interrupted run says what it has proved.
"$taut" gen rotor -n 4000 -o long.json
for signal in INT TERM; do
  timeout --foreground --preserve-status -s $signal 0.7 "$taut" check --engine kinetic long.json >out 2>err
  got=$?
  if [ $got != 3 ] || ! grep -q '^UNDECIDED' out || ! grep -q '  interrupted' out || ! grep -q 'proved free on' out; then
    echo "FAILED: SIG$signal gives exit code $got" && cat out err
    failures=$((failures + 1))
  fi
done

# Also while it is only being looked at: is each of these cosines within [-1, 1]?
{
  printf '{"format":"taut-scene/1","time":[-0.9,0.9],"bodies":[{"name":"p","polygon":[[0,0],[1,0],[0,1]]},{"name":"q","polygon":[[0,0],[1,0],[0,1]],"motion":['
  awk 'BEGIN { for (i = 1; i <= 40000; i++) print "{\"x\":[9],\"rotation\":{\"cosine\":[1,0,-128,0,2688,0,-21504,0,84480,0,-180224,0,212992,0,-131072,0,32768]},\"until\":" i / 44440 "}" }' | paste -sd,
  printf ']}]}'
} >cosines.json
expect 3 'the time limit was reached' '' check --max-seconds 0.2 cosines.json
# As long as a scene is being read, an interrupted run ends at once (130). Looking takes several times as long as reading.
for seconds in 0.3 0.5 0.8 1.2 2 3 5 8 12 20 30; do
  timeout --foreground --preserve-status -s INT "$seconds" "$taut" check cosines.json >out 2>err
  got=$?
  [ $got != 130 ] && break
done
if [ $got != 3 ] || ! grep -q '  interrupted' out; then
  echo "FAILED: SIGINT while a scene is validated gives exit code $got" && cat out err
  failures=$((failures + 1))
fi

# Proofs.
prove() { # prove SCENE CODE: writes a proof that taut and taut-verify accept
  expect "$2" 'proof in a\.proof' '' prove "$1" -o a.proof
  expect 0 '^VALID' '' verify "$1" a.proof
  "$(dirname "$taut")/taut-verify" "$1" a.proof >out 2>err || { echo "FAILED: taut-verify $1" && cat out err; failures=$((failures + 1)); }
}
prove free.json 0
expect 0 'free on \[0, 10\]' '' verify free.json a.proof
expect 0 '"valid":true,"outcome":"free"' '' verify --json free.json a.proof
is_json_lines
expect 1 'NOT VALID' '' verify hit.json a.proof
expect 1 'another scene' '' verify hit.json a.proof
head -c 50 a.proof >cut.proof
expect 1 'cut off' '' verify free.json cut.proof
expect 1 '"valid":false' '' verify --json free.json cut.proof
# Exact logs, for the checker that is proved.
expect 0 'the exact log is about \[0, 10\]' '' prove --exact free.json -o exact.log
head -c 24 exact.log | grep -q '{"format":"taut-exact/1"' || { echo "FAILED: exact log" && cat exact.log; failures=$((failures + 1)); }
expect 1 'taut-verified checks it' '' verify free.json exact.log
expect 1 '"exact_until":7\.' '' prove --exact --json hit.json -o exact.log
expect 2 '' 'leave one of the two out' prove --exact --clearance 0.5 free.json -o exact.log
prove hit.json 1
expect 0 'contact within \[.*: vertex [01] of hammer meets edge 2-3 of anvil' '' verify hit.json a.proof
cp a.proof hit.proof
expect 1 '"outcome":"contact"' '' prove --json --touch closed touch.json -o a.proof
expect 0 'touch closed' '' verify touch.json a.proof
expect 3 'proof in' '' prove --engine kinetic --max-seconds 0.2 long.json -o a.proof
expect 0 'nothing after that' '' verify long.json a.proof
rm -f a.proof
expect 1 'no proof was written' '' prove overlap.json -o a.proof
[ -e a.proof ] && { echo "FAILED: a proof of nothing"; failures=$((failures + 1)); }
cp hit.proof old.proof
expect 1 'no proof was written; old.proof is an older file, left as it was' '' prove overlap.json -o old.proof
expect 1 'overlap_at_start' 'no proof was written; old.proof is an older file' prove --json overlap.json -o old.proof
cmp -s hit.proof old.proof || { echo "FAILED: an older proof was touched"; failures=$((failures + 1)); }
cp hit.proof old.svg
expect 1 'OVERLAP' 'no picture was written; old.svg is an older file' separator overlap.json -o old.svg
expect 2 '' "max-events: '-1' is not a whole number" check free.json --max-events -1
expect 2 '' "max-events: '1.5' is not a whole number" check free.json --max-events 1.5
expect 2 '' "max-events: '1e30' is not a whole number" check free.json --max-events 1e30
expect 2 '' "max-events: '99999999999999999999' is not a whole number" check free.json --max-events 99999999999999999999
expect 2 '' "seed: '-1' is not a whole number" gen lock --seed -1
expect 2 '' 'tolerance: it is not at least 1e-12 and below 1' clearance free.json --tolerance 1.5
expect 2 '' 'no/a.proof: cannot write' prove free.json -o no/a.proof
expect 2 '' 'missing.proof: cannot open' verify free.json missing.proof
expect 2 '' 'no.json: cannot open' verify no.json cut.proof
if ls | grep -q '\.tmp'; then echo "FAILED: temporary files are left"; failures=$((failures + 1)); fi

# What a log should prove. The other program says the same, and nothing else.
verifies() { # verifies CODE 'PATTERN' ARGS: of both programs
  local code="$1" pattern="$2" verifier
  shift 2
  for verifier in "$taut verify" "$(dirname "$taut")/taut-verify"; do
    $verifier "$@" >out 2>err </dev/null
    [ $? = "$code" ] && cat out err | grep -qE -- "$pattern" || { echo "FAILED: $verifier $*: not $code, $pattern" && cat out err; failures=$((failures + 1)); }
  done
}
"$taut" prove free.json -o free.proof >/dev/null
"$taut" prove --max-events 0 hit.json -o nothing.proof >/dev/null
verifies 0 '^VALID' free.json free.proof --expect free
verifies 0 '^VALID' free.json free.proof --expect free --touch open --until 10
verifies 1 'NOT AS EXPECTED: free on \[0, 10\], touch closed' free.json free.proof --expect free --touch closed
verifies 1 'NOT AS EXPECTED: touch closed' free.json free.proof --touch closed
verifies 1 'NOT AS EXPECTED: a contact' free.json free.proof --expect contact
verifies 1 'NOT AS EXPECTED: free on \[0, 10\]' hit.json hit.proof --expect free
verifies 0 '^VALID' hit.json hit.proof --expect free --until 7.5
verifies 1 'NOT AS EXPECTED: free on \[0, 8.5\)' hit.json hit.proof --expect free --until 8.5
verifies 0 '^VALID' hit.json hit.proof --expect contact
verifies 0 '^VALID' hit.json hit.proof --expect contact --until 8.5
verifies 1 'NOT AS EXPECTED: a contact by t = 7.5' hit.json hit.proof --expect contact --until 7.5
verifies 0 'nothing after that' hit.json nothing.proof
verifies 1 'NOT AS EXPECTED' hit.json nothing.proof --expect free
verifies 1 'NOT AS EXPECTED' hit.json nothing.proof --expect contact
verifies 1 '"expected":"free on \[0, 10\]","as_expected":false' hit.json nothing.proof --json --expect free
verifies 0 '"as_expected":true' hit.json hit.proof --json --expect contact
verifies 0 '"t":\[[0-9.]+,[0-9.]+\],"contact":\{"vertex":\{"body":"hammer","index":[01]\},"edge":\{"body":"anvil","index":2\},.*"contact_at":"motion"' hit.json hit.proof --json
verifies 2 '--until: 11 is outside' hit.json hit.proof --expect free --until 11
verifies 2 '--until: no time passes before the start' hit.json hit.proof --expect free --until 0
verifies 2 '--until: nan is outside|--until' hit.json hit.proof --expect free --until nan
verifies 2 '--until requires --expect' hit.json hit.proof --until 3
verifies 2 '--expect' hit.json hit.proof --expect maybe
verifies 2 'cannot both come from' - -
verifies 2 'PROOF' hit.json
verifies 0 'Example' --help
verifies 1 'another scene' free.json hit.proof --expect free
"$taut" gen maze -n 4000 -o maze.json
"$taut" prove maze.json -o maze.proof >/dev/null
verifies 3 '^UNDECIDED' maze.json maze.proof --max-seconds 0
verifies 3 '"valid":null,"reason":"the time limit was reached"' maze.json maze.proof --max-seconds 0 --json
verifies 0 '^VALID' maze.json maze.proof --max-seconds 60 --expect free
for verifier in "$taut verify" "$(dirname "$taut")/taut-verify"; do
  for json in "" --json; do
    # shellcheck disable=SC2086
    $verifier $json hit.json hit.proof >/dev/full 2>err
    [ $? = 2 ] && grep -q 'cannot write to standard output' err || { echo "FAILED: $verifier cannot write"; failures=$((failures + 1)); }
  done
  cat hit.json | $verifier - hit.proof >out 2>err && grep -q '^VALID' out || { echo "FAILED: $verifier with a scene from standard input"; failures=$((failures + 1)); }
  cat hit.proof | $verifier hit.json - >out 2>err && grep -q '^VALID' out || { echo "FAILED: $verifier with a log from standard input"; failures=$((failures + 1)); }
done
# Between two pieces that join but for rounding, the hammer moves onto the anvil.
scene joint.json '[{"y":[-3.999999],"until":3},{"y":[-4.000001]}]' 10
expect 1 '^CONTACT .* t = 3$' '' check joint.json
expect 1 'proof in' '' prove joint.json -o joint.proof
verifies 0 'free on \[0, 3\); contact at the joint t = 3, in the jump .*: vertex [01] of hammer meets edge 2-3 of anvil' joint.json joint.proof
verifies 0 '"t":\[3,3\],.*"contact_at":"joint"' joint.json joint.proof --json
"$taut" prove --touch closed - -o start.proof >/dev/null <<<"$(sed 's/"y":\[0,-0.5\]/"y":[-4,-0.5]/' hit.json)"
sed 's/"y":\[0,-0.5\]/"y":[-4,-0.5]/' hit.json >start.json
verifies 0 '  contact at the start, t = 0: ' start.json start.proof
verifies 0 '"contact_at":"start"' start.json start.proof --json

# No signal leaves half a file behind.
"$taut" gen rotor -n 40000 -o longer.json
for signals in "HUP" "QUIT" "INT INT" "TERM TERM" "INT TERM"; do
  (ulimit -c 0; exec env --default-signal "$taut" prove --engine kinetic longer.json -o killed.proof) >out 2>err &
  pid=$!
  for _ in $(seq 100); do ls | grep -q '\.tmp' && break; sleep 0.05; done
  # The first one ends the run with an answer, unless the second one comes at once.
  for signal in $signals; do kill -s "$signal" $pid 2>/dev/null; done
  wait $pid
  if ls | grep -q '\.tmp'; then echo "FAILED: SIG$signals leaves a temporary file"; failures=$((failures + 1)); rm -f ./*.tmp*; fi
done
rm -f killed.proof
echo old >private.svg
chmod 600 private.svg
expect 0 '' '' draw free.json -o private.svg
[ "$(stat -c %a private.svg)" = 600 ] || { echo "FAILED: a file that is replaced gets another mode"; failures=$((failures + 1)); }

# Where the disk is full, or a limit of the shell says so, nothing is left behind.
"$taut" gen gears -n 2000 -o large.json
full() { # full FILE ARGS: runs taut where files end after 4 kB
  local file="$1" got
  shift
  (trap '' XFSZ && ulimit -f 4 && exec "$taut" "$@" -o "$file") >out 2>err </dev/null
  got=$?
  if [ $got != 2 ] || ! grep -q "$file: cannot write the file" err || [ -e "$file" ]; then
    echo "FAILED: taut $* with a full disk: exit code $got" && cat err
    failures=$((failures + 1))
  fi
}
full full.json gen gears -n 2000
full full.svg draw large.json
full full.proof prove large.json
echo 'the old text' >old.proof
(trap '' XFSZ && ulimit -f 4 && exec "$taut" prove large.json -o old.proof) >out 2>err </dev/null
[ "$(cat old.proof)" = 'the old text' ] || { echo "FAILED: a proof that could not be written spoils the old one"; failures=$((failures + 1)); }
if ls | grep -q '\.tmp'; then echo "FAILED: temporary files are left"; failures=$((failures + 1)); fi

# Bad scenes.
expect 2 '' 'no\.json: cannot open the file' check no.json
expect 2 '' 'cannot read the file: it is a folder' check .
expect 2 '' 'cannot read the file: it is a device' check /dev/zero
mkfifo pipe
for command in check trace draw view separator "prove -o x.proof" "check --lines"; do
  # shellcheck disable=SC2086
  expect 2 '' 'pipe: cannot read the file: it is a pipe' $command pipe
done
expect 2 '' 'pipe: cannot read the file: it is a pipe' verify free.json pipe
expect 2 '' 'pipe: cannot read the file: it is a pipe' verify pipe free.json
ln -s hit.json link.json
expect 1 '^CONTACT' '' check link.json
printf '%s\0 and more' "$(cat hit.json)" >nul.json
expect 2 '' 'nul.json:3:[0-9]+: a NUL character ends the JSON' check nul.json

# What a terminal would obey is shown instead, wherever it comes from.
quiet() { # quiet ARGS: no byte of the output is one that a terminal obeys
  "$taut" "$@" >out 2>err </dev/null
  if LC_ALL=C grep -qP '[\x00-\x09\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\x8e\x8f\xa8-\xae]|\xe2\x81[\xa6-\xa9]' out err; then
    echo "FAILED: taut $* prints control characters" && cat -v out err
    failures=$((failures + 1))
  fi
}
evil="$(printf 'e\x1b]0;title\x07\xc2\x9b31m\xe2\x80\xae\n')"
sed "s/anvil/an\xc2\x9b31m\xe2\x80\xaevil/" hit.json >"$evil.json"
sed 's/"time"/"ti\\u001b[31m\xe2\x80\xaeme"/' hit.json >key.json
sed 's/anvil/\x1b[31m/' hit.json >raw.json
printf 't,\x1b[31mx\n0,0\n' >evil.csv
scene evil_csv.json '{"csv":"evil.csv"}' 10
printf '{"type":"\\u001b[31m"}' >evil.geojson
sed 's/\[\[0,0\],\[4,0\],\[4,1\],\[0,1\]\]/{"geojson":"evil.geojson"}/' hit.json >evil_outline.json
"$taut" prove "$evil.json" -o evil.proof >/dev/null
for file in "$evil.json" "no$evil" key.json raw.json evil_csv.json evil_outline.json; do
  for command in check "check --json" "check --engine spacetime" "check --threads 1 free.json" trace draw separator "separator --json" \
    "view --template no" "prove -o $folder/x.proof" "prove --json -o $folder/x.proof"; do
    # shellcheck disable=SC2086
    quiet $command "$file"
  done
  quiet verify "$file" evil.proof
  quiet verify --json "$file" evil.proof
  quiet verify free.json "$file"
done
quiet check "--$evil"
quiet "$evil"
quiet demo "$evil"
quiet draw free.json -o "no$evil/x.svg"
quiet prove free.json -o "$evil.proof"
expect 1 'an.u009b31m.u202evil' '' check "$evil.json"
expect 1 '"an.u009b31m.u202evil"' '' check --json "$evil.json"
is_json_lines
rm -f ./*title* ./*evil* x.proof

# A scene does not choose what is read: neither where, nor by what an error quotes.
mkdir -p inner
echo 'POLYGON ((0 0, 4 0, 4 1, 0 1))' >outline.wkt
sed 's/\[\[0,0\],\[4,0\],\[4,1\],\[0,1\]\]/{"wkt":"..\/outline.wkt"}/' hit.json >inner/scene.json
tr -d '\n' <inner/scene.json >inner/scene.jsonl
ln -s ../outline.wkt inner/link.wkt
sed 's/..\/outline/link/' inner/scene.json >inner/linked.json
echo '<p>@TAUT-DATA@</p>' >page.html
for command in check "check --lines" "check free.json" trace draw separator "view --template page.html" "prove -o a.proof"; do
  file=inner/scene.json
  [ "$command" = "check --lines" ] && file=inner/scene.jsonl
  # shellcheck disable=SC2086
  "$taut" $command "$file" >out 2>err && { echo "FAILED: taut $command reads an outline outside"; failures=$((failures + 1)); }
  grep -q 'the file "../outline.wkt" is not below the scene.s folder' err || { echo "FAILED: taut $command: " && cat err; failures=$((failures + 1)); }
  # shellcheck disable=SC2086
  "$taut" $command --allow-outside "$file" >out 2>err || [ $? = 1 ] || { echo "FAILED: taut $command --allow-outside" && cat err; failures=$((failures + 1)); }
done
expect 2 '' 'not below' verify inner/scene.json a.proof
expect 0 '^VALID' '' verify --allow-outside inner/scene.json a.proof
expect 2 '' 'not below' check inner/linked.json
expect 1 '^CONTACT' '' check --allow-outside inner/linked.json
"$taut" check - <inner/scene.json >out 2>err
[ $? = 2 ] && grep -q 'not below' err || { echo "FAILED: an outline outside of a scene from standard input"; failures=$((failures + 1)); }
sed 's/..\/outline.wkt/secret/' inner/scene.json >inner/peeping.json
echo 'password:hunter2' >inner/secret
expect 2 '' 'secret:1:9: expected POLYGON' check inner/peeping.json
grep -qi 'hunter\|password' err && { echo "FAILED: an error quotes an outline" && cat err; failures=$((failures + 1)); }
rm -rf inner
# Worlds: what is wrong is said with its place; what takes two polygons says so, and writes nothing.
world() { echo '{"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"a","polygon":[[0,0],[1,0],[0,1]]},'"$1"']'"${2:-}"'}' >world.json; }
world '{"name":"b","polygon":{"outline":[[2,0],[9,0],[9,9],[2,9]],"holes":[[[3,3],[4,3],[4,4],[3,4]]]}}'
expect 0 '^FREE' '' check world.json
expect 0 '"tested":1,.*"pairs":\[\{"bodies":\["a","b"\],"outcome":"free"\}\]' '' check --json --pairs all world.json
expect 2 '' 'world\.json: bodies: a separator needs two bodies, each one polygon' separator world.json
expect 1 'closer than 0.5 at t = ' '' check --clearance 0.5 hit.json
expect 1 '"outcome":"contact","clearance":0.5,"t":' '' check --json --clearance 0.5 hit.json
expect 2 '' "clearance: '0' is not more than 0" check --clearance 0 hit.json
expect 2 '' 'clearance: it is not a positive number' check --clearance inf hit.json
expect 1 '"fit":0.001}' '' check --json --fit 0.001 hit.json
expect 2 '' 'for a fit of 100' check --fit 100 hit.json
expect 2 '' 'a clearance is that of bodies as they are' check --clearance 1 --fit 0.1 hit.json
expect 1 'closer than 1 at t = \[5.99' '' check --clearance 1 free.json hit.json
expect 2 '' 'it draws one scene' check --clearance 1 --svg - hit.json free.json
expect 0 'proof in kept.proof' '' prove --clearance 0.001 -o kept.proof free.json
expect 0 'all keep 0.001 on' '' verify free.json kept.proof --expect free --clearance 0.001
expect 1 'NOT AS EXPECTED: .*clearance 0.002' '' verify free.json kept.proof --expect free --clearance 0.002
expect 0 '"clearance":0.001' '' verify --json free.json kept.proof --expect free
expect 1 'proof in broken.proof' '' prove --clearance 0.5 -o broken.proof hit.json
expect 0 'closer within' '' verify hit.json broken.proof --expect contact --clearance 0.5
expect 1 'NOT AS EXPECTED' '' verify hit.json broken.proof --expect contact
expect 1 'NOT AS EXPECTED' '' verify hit.json broken.proof --expect free
expect 1 'NOT AS EXPECTED: no way' '' verify hit.json broken.proof --expect none
expect 2 '' 'clearance: it is not a positive number' prove --clearance 0 -o x.proof hit.json
expect 1 '^LOCKED  a x b' '' separate "$(world '{"name":"b","polygon":{"outline":[[-9,-9],[9,-9],[9,9],[-9,9]],"holes":[[[-3,-3],[4,-3],[4,4],[-3,4]]]}}' && echo world.json)"
expect 1 '"outcome":"locked","body":"b","all":false,"directions":\[\]' '' separate --json world.json
world '{"name":"b","polygon":[[2,0],[9,0],[9,9],[2,9]]}'
expect 0 'b goes' '' separate world.json
expect 1 '^OVERLAP AT START' '' separate "$(world '{"name":"b","polygon":[[0,0],[9,0],[9,9],[0,9]]}' && echo world.json)"
world '{"name":"b","polygon":{"outline":[[2,0],[9,0],[9,9],[2,9]],"holes":[[[3,3],[4,3],[4,4],[3,4]]]}}'
expect 1 '^COLLIDES  for some combinations of lift from -35 to 50' '' envelope "$examples/linkages/loader.json"
expect 1 '"outcome":"contact","joints":\[{"name":"door","range":\[0,120\]}' '' envelope --json "$examples/linkages/door.json"
expect 1 '"cells":\[{"state":' '' envelope --json --cells --tolerance 0.1 "$examples/linkages/lift.json"
expect 1 'class="colliding"' '' envelope --svg - "$examples/linkages/lift.json"
printf '<p>@TAUT-DATA@</p>' >map.html
expect 1 'COLLIDES' '' envelope "$examples/linkages/loader.json" --tolerance 0.1 --html map_of_loader.html --template map.html
grep -q '^<p>{"title":"loader","envelope":{"outcome":"contact".*"bodies":\[{"name":"tractor","parts":\[\[\[\[-3.2' map_of_loader.html ||
  { echo "FAILED: the envelope's page" && head -c 300 map_of_loader.html; failures=$((failures + 1)); }
expect 1 '^<p>{"title"' '' envelope "$examples/linkages/loader.json" --tolerance 0.1 --html - --template map.html
expect 2 '' 'not a template' envelope "$examples/linkages/loader.json" --tolerance 0.1 --html - --template "$examples/lid.json"
expect 2 '' 'the scene has 3 joints, and a picture' envelope --tolerance 0.3 --svg - "$examples/paths/bracket.json"
expect 3 'time limit' '' envelope --max-seconds 0 "$examples/linkages/lift.json"
expect 2 '' 'tolerance: it is not between' envelope --tolerance 0 "$examples/linkages/lift.json"
expect 2 '' 'joints instead of a time' check "$examples/linkages/lift.json"
expect 2 '' 'piano.json:3:13: joints: the scene has joints instead of a time' check "$examples/paths/piano.json"
expect 2 '' '"joints"' envelope hit.json
echo '{"format":"taut-scene/1","joints":{"x":[0,2]},"bodies":[{"name":"a","polygon":[[0,0],[1,0],[0,1]],"motion":{"slide":{"direction":[1,0],"by":"y"}}}]}' > joints.json
expect 2 '' 'there is no joint "y"' envelope joints.json
expect 0 '^PATH  from the start to the goal' '' path "$examples/paths/piano.json" -o moved.json
expect 0 '^FREE' '' check moved.json
expect 0 'proof in moved.proof' '' prove -o moved.proof moved.json
expect 0 '^VALID' '' verify moved.json moved.proof --expect free
expect 0 '"format":"taut-scene/1"' '' path "$examples/paths/piano.json" -o -
expect 0 '"outcome":"path","waypoints":\[{"x":0.7,"y":3.6,"turn":90},' '' path --json --touch closed "$examples/paths/piano.json"
expect 1 '^NONE  there is no way' '' path "$examples/paths/piano_long.json"
expect 1 '"cells":\[{"state":' '' path --json --cells "$examples/paths/piano_long.json"
expect 0 '<animate' '' path --svg - "$examples/paths/arm.json"
expect 0 '"clearance":0.05' '' path --json --clearance 0.05 "$examples/paths/piano.json"
expect 2 '' 'start: "piano" and "walls" are nearer than the clearance' path --clearance 0.3 "$examples/paths/piano.json"
expect 3 'limit of cells' '' path --max-cells 10 "$examples/paths/piano_long.json"
expect 3 'time limit' '' path --max-seconds 0 "$examples/paths/piano.json"
expect 2 '' 'tolerance: it is not between' path --tolerance 0 "$examples/paths/piano.json"
expect 2 '' '"start" is missing' path "$examples/linkages/lift.json"
expect 2 '' '^hint: write a scene as .*"start":."x":1.,"goal":."x":8.' path "$examples/linkages/lift.json"
expect 1 'COLLIDES' '' envelope --tolerance 0.2 "$examples/paths/bracket.json"
expect 1 'proof in none.proof, scene [0-9a-f]{16}$' '' prove "$examples/paths/piano_long.json" -o none.proof
expect 0 '^VALID  piano x walls' '' verify "$examples/paths/piano_long.json" none.proof
expect 0 '"valid":true,"outcome":"none","touch":"open","cells":' '' verify --json "$examples/paths/piano_long.json" none.proof
expect 1 '^NOT VALID.*' '' verify "$examples/paths/piano.json" none.proof
expect 1 'NOT AS EXPECTED: free' '' verify --expect free "$examples/paths/piano_long.json" none.proof
expect 0 '^VALID' '' verify --expect none --touch open "$examples/paths/piano_long.json" none.proof
expect 0 '"as_expected":true' '' verify --expect none --json "$examples/paths/piano_long.json" none.proof
expect 1 'NOT AS EXPECTED: .*touch closed' '' verify --expect none --touch closed "$examples/paths/piano_long.json" none.proof
expect 2 '' 'has a time instead of joints' verify free.json none.proof
expect 0 'no proof was written' '' prove "$examples/paths/piano.json" -o way.proof
[ -e way.proof ] && { echo "FAILED: a proof of a way that is none"; failures=$((failures + 1)); }
expect 2 '' 'about joints' prove --tolerance 0.1 free.json -o free.proof
expect 0 'proof in world.proof' '' prove -o world.proof world.json
expect 0 '^VALID' '' verify world.json world.proof --expect free
expect 1 'NOT VALID' '' verify three.json world.proof
expect 0 'proof in two.proof' '' prove --engine spacetime -o two.proof free.json
expect 0 '"separations":' '' verify --json free.json two.proof --expect free
world '{"name":"b","parts":[[[0,0],[1,0],[1,1]],[[5,0],[6,0],[5,1]]]}'
expect 1 'when the motion starts: \(0.5, 0.0625\) is inside both$' '' check world.json
world '{"name":"b","polygon":{"outline":[[2,0],[9,0],[9,9],[2,9]],"holes":[[[3,3],[10,3],[4,4]]]}}'
expect 2 '' 'world\.json: b: edge 1-2 of the outline meets edge' check world.json
world '{"name":"b","polygon":{"outline":[[2,0],[9,0],[9,9],[2,9]],"holes":[[[13,3],[14,3],[14,4]]]}}'
expect 2 '' 'world\.json: b: hole 1: the hole lies outside of the outline' check world.json
world '{"name":"b","parts":[]}'
expect 2 '' 'bodies\[1\]\.parts: there are no parts' check world.json
world '{"name":"b","relative_to":"c","polygon":[[0,0],[1,0],[0,1]]}'
expect 2 '' 'b: there is no body "c" for it to be relative to' check world.json
world '{"name":"b","relative_to":"b","polygon":[[0,0],[1,0],[0,1]]}'
expect 2 '' 'b: it is relative to itself' check world.json
world '{"name":"b","polygon":[[0,0],[1,0],[0,1]]}' ',"ignore":[["a","lid"]]'
expect 2 '' 'ignore\[0\]: there is no body "lid"' check world.json
world '{"name":"a","polygon":[[0,0],[1,0],[0,1]]}'
expect 2 '' 'two bodies are called "a"' check world.json
sed 's/"time"/"tiem"/' hit.json >bad.json
expect 2 '' 'bad\.json:1:26: unknown key "tiem"' check bad.json
expect 2 '' 'did you mean "time"' check --json bad.json
expect 2 '' 'unknown key' trace bad.json
expect 2 '' 'unknown key' draw bad.json
head -c 1000000 /dev/zero | tr '\0' '[' >deep.json
for command in check trace "prove -o x.proof" "draw -o x.svg"; do
  # shellcheck disable=SC2086
  expect 2 '' 'nested more than 32 deep' $command deep.json
done
[ -e x.proof ] || [ -e x.svg ] && { echo "FAILED: a file of a scene that cannot be read"; failures=$((failures + 1)); }
echo '{"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"P","polygon":[[0,0],[1,1],[1,0],[0,1]]},
  {"name":"Q","polygon":[[5,0],[6,0],[5,1]]}]}' >bow.json
expect 2 '' 'bow\.json: .*P' check bow.json
head -c 60 hit.json >cut.json
expect 2 '' 'cut off' check cut.json
: >empty.json
expect 2 '' 'the file is empty' check empty.json

# Motions in degrees.
scene sweep.json '{"sweep":{"pivot":[9,3],"from_deg":0,"to_deg":90}}' 1
expect 1 '^CONTACT .*t = .*   \(angle [0-9.]+ deg\)$' '' check sweep.json
expect 1 '"angle_deg":\[[0-9.]+,[0-9.]+\]\}' '' check --json sweep.json
expect 1 'proof in' '' prove sweep.json -o a.proof
expect 0 'contact within \[.*, at an angle within \[[0-9.]+, [0-9.]+\] deg: vertex' '' verify sweep.json a.proof
scene frames.json '{"keyframes":[{"t":0,"y":0},{"t":10,"y":-5}]}' 10
expect 1 '"outcome":"contact","t":\[(8|7\.99999)' '' check --json frames.json
printf 't,y\n0,0\n10,-5\n' >frames.csv
scene csv.json '{"csv":"frames.csv"}' 10
expect 1 '"outcome":"contact","t":\[(8|7\.99999)' '' check --json csv.json
mkdir -p elsewhere && (cd elsewhere && "$taut" check ../csv.json >/dev/null) && { echo "FAILED: csv.json from elsewhere"; failures=$((failures + 1)); }
[ -s err ] && { echo "FAILED: csv.json"; failures=$((failures + 1)); }
printf 't,y\n0,0\n0,-5\n' >frames.csv
expect 2 '' 'csv\.json:.*motion\.csv: frames\.csv:3:1: the time is not later' check csv.json
rm frames.csv
expect 2 '' 'csv\.json:.*frames\.csv: cannot open' check csv.json
scene frames.json '{"keyframe":[{"t":0}]}' 10
expect 2 '' 'did you mean "keyframes"' check frames.json
expect 0 '"title": "taut-scene/1"' '' schema

# Traces.
expect 1 '"outcome":"contact"' '' trace hit.json
is_json_lines
expect 1 '^\{"event":1,"t":\[.*"repair":".*"corner":\[\{"body":.*"flags":\[.*"certificates":' '' trace hit.json
expect 0 '"outcome":"free"' '' trace --json free.json

# Pictures.
expect 0 '^<svg .*' '' draw free.json --at 1
expect 0 '' '' draw free.json --at 1 -o picture.svg
grep -q '</svg>' picture.svg || { echo "FAILED: no picture"; failures=$((failures + 1)); }
expect 0 '>contact<' 'touch at t = ' draw hit.json --at 9
expect 0 '>contact<' '' draw hit.json
expect 2 '' '--at: 11 is outside' draw free.json --at 11
expect 2 '' 'no/picture.svg: cannot write' draw free.json -o no/picture.svg
expect 0 '>geodesic of anvil<' '' draw free.json --at 1 --level 0
expect 0 'geodesic of hammer' '' draw free.json --level 40
expect 2 '' '--level' draw free.json --level -1

# Pictures that move.
expect 0 '</svg>' '' draw hit.json --animate
expect 0 '<animateTransform .*attributeName="transform"' '' draw hit.json --animate
expect 0 '>contact at t = 8<' '' draw hit.json --animate
expect 0 '>free<' '' draw free.json --animate
expect 0 'prefers-reduced-motion' '' draw free.json --animate
expect 0 '>overlap at the start<' 'overlap at the start; drawing that instant' draw overlap.json --animate
expect 0 '>overlap: ' 'overlap at the start; drawing that instant' draw overlap.json
expect 2 '' '--animate excludes --at|--at excludes --animate' draw free.json --animate --at 1
"$taut" gen gears -n 600 | "$taut" draw - --animate -o moving.svg
[ "$(stat -c %s moving.svg)" -lt 200000 ] || { echo "FAILED: a large moving picture"; failures=$((failures + 1)); }

# Pictures of worlds.
world '{"name":"b","polygon":{"outline":[[2,0],[9,0],[9,9],[2,9]],"holes":[[[3,3],[8,3],[8,8],[3,8]]]}},
  {"name":"c","polygon":[[4,4],[5,4],[5,5]],"motion":{"velocity":[6,0]}},
  {"name":"d","polygon":[[6,4],[7,4],[7,5]],"relative_to":"c"}' ',"ignore":[["a","*"]]'
expect 0 '<title>4 bodies, t = 0\.1</title>' '' draw world.json --at 0.1
expect 0 '>contact: b x d<' '' draw world.json
expect 0 '>ignored \(1\): a x every other body<' '' draw world.json
expect 0 '>contact: b x d<' 'b x d touch at t = 0\.1666.*; drawing that instant' draw world.json --at 0.9
expect 0 '>contact at t = 0\.16666[67]<' '' draw world.json --animate
expect 2 '' '--at: 3 is outside' draw world.json --at 3
expect 2 '' '--level: there are no geodesic cycles of these bodies' draw world.json --level 1
world '{"name":"b","polygon":[[0.5,0],[9,0],[9,9]]},{"name":"c","polygon":[[20,4],[21,4],[21,5]],"motion":{"velocity":[6,0]},"relative_to":"b"}'
expect 0 '<title>a, b, c, t = 1</title>' '' draw world.json
sed -i 's/"name":"b"/&,"motion":{"velocity":[1,0]}/' world.json
expect 0 '>overlap: a x b<' 'a x b overlap at the start; drawing that instant' draw world.json
expect 0 '>overlap at the start<' 'a x b overlap at the start' draw world.json --animate

# Demos.
expect 0 'lid .*bin' '' demo
mkdir demos
for name in $("$taut" demo | sed -n 's/^  \([a-z]*\) .*/\1/p'); do
  expect 0 "next:  $taut check demos/$name.json" '' demo "$name" -d demos
  "$taut" check "demos/$name.json" >out || [ $? = 1 ] || { echo "FAILED: demo $name"; failures=$((failures + 1)); }
  grep -q '</svg>' "demos/$name.svg" || { echo "FAILED: demo $name has no picture"; failures=$((failures + 1)); }
done
[ "$(ls demos | wc -l)" -ge 12 ] || { echo "FAILED: few demos"; failures=$((failures + 1)); }
# What it says to type next works as it stands: whatever the folder is called, and however the program was found.
mkdir "it's a folder" found
ln -s "$taut" found/taut
for call in "$taut" found/taut; do
  "$call" demo lid -d "it's a folder" --force | sed -n 's/^next:  //p' >next
  bash ./next >said || [ $? = 1 ]
  grep -q '^CONTACT  bin x lid' said || { echo "FAILED: $(cat next)"; failures=$((failures + 1)); }
done
PATH="$PWD/found:$PATH" taut demo lid -d demos --force | grep -qx 'next:  taut check demos/lid.json' ||
  { echo "FAILED: demo from the path"; failures=$((failures + 1)); }
expect 2 '' 'demos/lid.json: the file is there already' demo lid -d demos
expect 0 'next' '' demo lid -d demos --force
expect 2 '' 'no demo "ldi"' demo ldi
expect 2 '' 'no/lid.json: cannot write' demo lid -d no

# Pages. The template is a stand-in here; the browser tests use the true one.
echo '<script type="application/json">@TAUT-DATA@</script><script>page</script>' >page.html
expect 0 '^<script type="application/json">\{"touch":"open","title":"free","scene":\{"format":"taut-scene/1",' '' view free.json --template page.html
expect 0 '\{"touch":"closed","at":2.5,"title":"a \\"title\\"","scene"' '' view free.json --template page.html --touch closed --at 2.5 --title 'a "title"'
expect 0 '"touch":"open","title":"free","ask":\{"intervals":\{\},"clearance":\{\},"distance_profile":\{"instants":50\},"separate":\{\}\},"scene"' '' \
  view free.json --template page.html --intervals --clearance --profile 50 --separate
expect 0 '"at":1,"title":"free","ask":\{"separate":\{\}\},"scene"' '' view free.json --template page.html --separate --at 1
expect 2 '' 'profile' view free.json --template page.html --profile 1
expect 0 '' '' view free.json --template page.html -o a.html
"$taut" view - --template page.html --title free <free.json >b.html
cmp -s a.html b.html || { echo "FAILED: the same scene gives different pages"; failures=$((failures + 1)); }
sed 's|anvil|</script><!--anvil|' free.json >evil.json
expect 0 'name":"\\u003c/script>\\u003c!--anvil"' '' view evil.json --template page.html
[ "$(grep -o '</script>' out | wc -l)" = 2 ] || { echo "FAILED: a name ends the script"; failures=$((failures + 1)); }
expect 2 '' 'no/page.html: cannot write' view free.json --template page.html -o no/page.html
expect 2 '' 'none.html: cannot open' view free.json --template none.html
expect 2 '' 'free.json: not a template of the viewer' view free.json --template free.json
expect 2 '' '--at: 11 is outside' view free.json --template page.html --at 11
expect 2 '' 'bow.json: P: the boundary is not simple' view bow.json --template page.html -o x.html
# Worlds as they are; what is wrong with one is said as by check.
world '{"name":"b","polygon":{"outline":[[2,0],[9,0],[9,9],[2,9]],"holes":[[[3,3],[4,3],[4,4],[3,4]]]},"relative_to":"a"}' ',"ignore":[["a","*"]]'
expect 0 '"ignore":\[\["a","\*"\]\]' '' view world.json --template page.html
sed -i 's/"relative_to":"a"/"relative_to":"q"/' world.json
expect 2 '' 'world.json: b: there is no body "q" for it to be relative to' view world.json --template page.html -o x.html
[ -e x.html ] && { echo "FAILED: a page of a bad scene"; failures=$((failures + 1)); }
# Without a page nearby, the error names the remedy; beside the executable, the page is found.
mkdir bin
cp "$taut" bin/taut
bin/taut view free.json >out 2>err
[ $? = 2 ] && grep -q "hint: build it with .\./dev web" err || { echo "FAILED: taut view without a template" && cat err; failures=$((failures + 1)); }
mkdir -p share/taut && cp page.html share/taut/viewer.html
bin/taut view free.json >c.html && cmp -s a.html c.html || { echo "FAILED: the installed page is not found"; failures=$((failures + 1)); }
rm -rf bin share

# Many scenes: answers in their order whatever the threads, errors in their place, the worst exit code of all.
tr -d '\n' <hit.json >lines.jsonl
echo >>lines.jsonl
echo >>lines.jsonl
tr -d '\n' <free.json >>lines.jsonl
expect 1 '"scene":"lines.jsonl:3","outcome":"free"' '' check --json --lines lines.jsonl
is_json_lines
expect 1 '"scene":"hit.json","outcome":"contact"' '' check --json free.json hit.json free.json
[ "$(grep -o '"scene":"[a-z.]*"' out | tr '\n' ' ')" = '"scene":"free.json" "scene":"hit.json" "scene":"free.json" ' ] ||
  { echo "FAILED: answers out of order" && cat out; failures=$((failures + 1)); }
expect 0 'FREE' '' check free.json free.json
expect 2 '"error":' 'bad.json' check --json bad.json hit.json
is_json_lines
[ "$(wc -l <out)" = 2 ] || { echo "FAILED: a scene without an answer"; failures=$((failures + 1)); }
expect 2 '' 'missing.jsonl: cannot open' check --lines missing.jsonl
expect 1 '"outcome"' '2 scenes in .* 1 thread$' check --json --timing --threads 1 --lines lines.jsonl
for i in $(seq 60); do cat lines.jsonl; echo; done >many.jsonl
"$taut" check --json --lines --threads 1 many.jsonl >one.out
"$taut" check --json --lines --threads 4 - <many.jsonl | sed 's/<stdin>/many.jsonl/' >four.out
[ "$(wc -l <one.out)" = 120 ] && cmp -s one.out four.out || { echo "FAILED: threads change the output"; failures=$((failures + 1)); }

# Separators.
expect 0 'fewest links: 1, a line' '' separator free.json
expect 0 'hulls do not touch' '' separator free.json --at 1
expect 0 '"lower":1,"upper":1,"closed":false,"vertices":\[\[' '' separator --json free.json
is_json_lines
expect 1 'OVERLAP' '' separator overlap.json
expect 1 '"overlap":true' '' separator --json overlap.json
is_json_lines
expect 2 '' '--at: 11 is outside' separator free.json --at 11
expect 2 '' 'unknown key' separator bad.json
rm -f picture.svg
expect 0 'fewest links' '' separator free.json -o picture.svg
grep -q '>separator<' picture.svg || { echo "FAILED: no picture of a separator"; failures=$((failures + 1)); }
expect 2 '' 'no/picture.svg: cannot write' separator free.json -o no/picture.svg

# Curves.
cat >discs.json <<'END'
{"format":"taut-scene/1","time":[0,10],"bodies":[
 {"name":"wheel","polygon":{"path":"M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"}},
 {"name":"roller","polygon":{"path":"M12 1 A2 2 0 0 1 8 1 A2 2 0 0 1 12 1 Z"},"motion":{"velocity":[-1,0]}}]}
END
expect 1 'CONTACT  wheel x roller   t = 7\.17157287' '' check discs.json
expect 1 '"geometry":{"tolerance":' '' check --json --time-tolerance 1e-6 discs.json
expect 2 '' 'time tolerance: it is not between' check --time-tolerance 0 discs.json
expect 1 'CLEARANCE  0 .*7\.17157287' '' clearance discs.json
expect 1 'closer than 0\.5 at t = 6\.64589803' '' check --clearance 0.5 discs.json
expect 0 'A[0-9.]*,[0-9.]* 0 0 0 ' '' draw discs.json
expect 0 '"polygon":\[\[1,0\]' '' flatten --outer --tolerance 0.1 discs.json
expect 2 '' 'the side of the curves is missing' flatten --tolerance 0.1 discs.json
expect 2 '' 'doubles do not allow a tolerance' flatten --inner --tolerance 1e-30 discs.json
prove discs.json 1
expect 0 'contact within \[7\.17157287.*segment 0 .* meets segment 1 ' '' verify discs.json a.proof --expect contact
expect 0 '"separations":[0-9]*,"segments":[0-9]' '' verify --json discs.json a.proof
sed 's/A1 1 0 0 1 -1 0/A1 1 0 0 0 -1 0/' discs.json >other.json
expect 1 'NOT VALID' '' verify other.json a.proof
expect 1 'closer than 0\.5' '' prove discs.json --clearance 0.5 -o a.proof
expect 0 'all keep 0\.5 on \[0, 6\.64589803' '' verify discs.json a.proof --clearance 0.5 --expect contact
for command in trace separator "cells --resolution 1"; do
  # shellcheck disable=SC2086
  expect 2 '' 'bounded by curves.*|taut flatten' $command discs.json
done

expect 0 '"path":"M 1 0 A 1 1 0 0 1 -1 0' '' view discs.json --template page.html
expect 1 '^  +5 +2\.09901951 ' '' clearance --profile 3 discs.json
expect 1 '"geometry":{"tolerance":' '' clearance --profile 3 --json discs.json

# Generators: what they promise.
for kind in gears combs lock jigsaw dips rotor spiral maze; do
  expect 0 '-n N' '' gen "$kind" --help
  expect 0 '' '' gen "$kind" -o scene.json
  expect 0 '"outcome":"free"' '' check --json scene.json
  expect 0 '' '' gen "$kind" --hit -o scene.json
  expect 1 '"outcome":"contact"' '' check --json scene.json
  expect 0 '"format":"taut-scene/1"' '' gen "$kind" -n 100
done
expect 2 '' 'hint: one of gears,' gen
expect 2 '' 'hint: did you mean gears\?' gen gaers
expect 2 '' 'hint: did you mean --pairs\?' check --pair all hit.json
expect 2 '' "--at: 'abc' is not a number" draw hit.json --at abc
expect 2 '' 'time tolerance: it is not between' check --time-tolerance 0 hit.json
for words in --help man 'completion bash' demo; do
  "$taut" $words >/dev/full 2>err
  [ $? = 2 ] && grep -q 'cannot write to standard output' err || { echo "FAILED: taut $words >/dev/full"; failures=$((failures + 1)); }
done
# What a shell opens for a command is read to its end; a pipe that somebody made is not.
expect 1 '^CONTACT' '' check <(cat hit.json)
truncate -s 1200M big.json
expect 2 '' 'big.json: the file is larger than the limit' check big.json
rm big.json
expect 2 '' '--teeth1: 3 is out of range' gen gears --teeth1 3

all_are_json_lines

[ "$failures" = 0 ] && echo "all well"
exit "$((failures > 0))"
