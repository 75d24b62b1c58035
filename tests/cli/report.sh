#!/bin/sh
# crumple report and crumple audit: the expert's report, and a result computed again.
. "$SRC/tests/cli/cli.sh"
wall_scene >"$tmp/wall.json"
quick="--draws=10 --quiet"
quicker="$quick --no-tests" # where the crash tests beside it are of no account

# quick is words
# shellcheck disable=SC2086
run report "$tmp/wall.json" $quick -o "$tmp/r.html" --author="A. Expert" --case="12 O 34/26"
same "a report is written" "$status$out$errs" 0
html=$(cat "$tmp/r.html")
n=1
for section in Subject Question Inputs Method 'The crash' Pulses Deformation Balance Uncertainty \
    Validity Limits 'How to repeat' Annex; do
    has "section $n" "$html" "<h2>$n $section"
    n=$((n + 1))
done
has "author and case" "$html" '12 O 34/26'
to=' \([0-9.]+ to' bis=' \([0-9,]+ bis'
"$crumple" --version | grep -q 'no GSL' && to='' bis=''
has "an interval stands with the EES" "$html" "<td>EES</td><td>[0-9.]+ km/h$to"
has "what was given" "$html" '<td>speed_kmh</td><td>50</td><td>km/h</td><td></td><td>given</td>'
has "what was assumed, marked" "$html" '<tr class="assumed"><td>track_m</td>'
has "the command line" "$html" 'crumple report .*wall.json --draws=10'
has "crash tests like it" "$html" 'full-width rigid wall.* tests'
sed 's/"shape": "wall"/"shape": "pole", "radius_m": 0.15/' "$tmp/wall.json" >"$tmp/pole.json"
run report "$tmp/pole.json" --draws=0 -q -o "$tmp/pole.html" --lang=de
has "crash tests like a frontal pole" "$(cat "$tmp/pole.html")" 'schmale Hindernisse frontal'
has "the scene as it was given" "$html" '&quot;crumple&quot;: 1, &quot;name&quot;: &quot;small'
same "nothing from outside" "$(grep -cE '(src|href)=|<script|@import|url\(' "$tmp/r.html")" 0
dates=$(grep -ciE '<td>Date</td>|20[0-9]{2}-[0-9]{2}-[0-9]{2}' "$tmp/r.html")
same "no date unless asked for" "$dates" 0
hash=$("$crumple" run "$tmp/wall.json" | sha256sum | cut -d' ' -f1)
has "the result's hash is that of crumple run" "$html" "Result, SHA-256</td><td>$hash"
if python3 -c '' 2>/dev/null; then
    python3 - "$tmp/r.html" <<'END' >"$tmp/errs" 2>&1
import sys
from html.parser import HTMLParser
class P(HTMLParser):
    open_tags = []
    def handle_starttag(self, tag, attrs):
        if tag != "meta":
            self.open_tags.append(tag)
    def handle_startendtag(self, tag, attrs):
        pass
    def handle_endtag(self, tag):
        assert self.open_tags.pop() == tag, tag
p = P()
p.feed(open(sys.argv[1], encoding="utf-8").read())
assert p.open_tags == [], p.open_tags
END
    same "every element is closed" "$?$(cat "$tmp/errs")" 0
fi
# shellcheck disable=SC2086
"$crumple" report "$tmp/wall.json" $quick -o "$tmp/r.html" --author="A. Expert" --case="12 O 34/26"
same "the same bytes on every run" "$(cksum <"$tmp/r.html")" "$(printf '%s\n' "$html" | cksum)"

# shellcheck disable=SC2086
run report "$tmp/wall.json" $quicker -o "$tmp/de.html" --lang=de --date=2026-11-28
has "in German" "$(cat "$tmp/de.html")" '<h2>3 Eingaben und ihre Herkunft'
has "with a decimal comma" "$(cat "$tmp/de.html")" "EES</td><td>[0-9]+,[0-9] km/h$bis"
has "with its date" "$(cat "$tmp/de.html")" 'Datum</td><td>2026-11-28'
points=$(grep -cE '<text[^>]*>[^<]*[0-9][.][0-9]' "$tmp/de.html")
same "in the pictures too" \
    "$points$(grep -cE '<text[^>]*>[^<]*[0-9],[0-9]+ ms' "$tmp/de.html")" 02
empty "zero has no sign" "$(grep -oE "<td>-0,0+</td>" "$tmp/de.html")"
empty "who has a position of his own does not stand against another" \
    "$(printf "%s" "$html" | grep -o "<td>place\.overlap[^<]*")"
left=$(sed -n 's/.*W(p, "\([A-Z][^"\\]*\)").*/\1/p' "$SRC"/src/report/section_*.c | sort -u |
    while read -r text; do
        grep -qF "{\"$text" "$SRC/src/report/german.h" || echo "$text"
    done)
empty "every text is in the table of German" "$left"

if "$crumple" --version | grep -q 'cairo'; then
    # shellcheck disable=SC2086
    run report "$tmp/wall.json" $quicker -o "$tmp/r.pdf"
    same "a PDF is written" "$status$errs$(head -c 5 "$tmp/r.pdf")" "0%PDF-"
    first=$(cksum <"$tmp/r.pdf")
    # shellcheck disable=SC2086
    run report "$tmp/wall.json" $quicker -o "$tmp/r.pdf"
    same "the same PDF every time" "$(cksum <"$tmp/r.pdf")" "$first"
    run report "$SRC/share/scenes/offset-car.json" --draws=10 --no-tests -q -o "$tmp/o.pdf"
    if command -v pdftotext >/dev/null; then
        pdftotext -layout "$tmp/o.pdf" "$tmp/o.txt"
        alone=$(tr '\f' '\n' <"$tmp/o.txt" | grep -v '^ *$' | grep -B1 ' [0-9]* / [0-9]*$' |
            grep -E '^ *([0-9]+ [A-Z]|[A-Z]: |Note in the|Input  )')
        empty "no heading is left alone at the foot of a page" "$alone"
        empty "every character can be drawn" "$(grep � "$tmp/o.txt")"
    else
        skip "the words of a PDF" "no pdftotext"
    fi
    # shellcheck disable=SC2086
    run report "$tmp/wall.json" $quick --paper=letter -o "$tmp/l.pdf"
    has "on Letter" "$(grep -a MediaBox "$tmp/l.pdf")" '612 792'
    { cat "$tmp/wall.json" && yes '' | head -n 170000; } >"$tmp/long.json"
    refused "a book" 3 'more than 2000 pages' report "$tmp/long.json" --draws=0 --no-tests -q \
        -o "$tmp/long.pdf"
else
    skip "PDF" "a build without cairo"
fi

refused "no file" 2 'wants -o FILE.html or FILE.pdf' report "$tmp/wall.json"
refused "an unknown form" 2 'neither .html nor .pdf' report "$tmp/wall.json" -o "$tmp/r.doc"
refused "no scene" 2 'no/such.json' report no/such.json -o "$tmp/r.html"
refused "an unknown language" 2 'lang' report "$tmp/wall.json" -o "$tmp/r.html" --lang=fr
scene bad.json '{ "crumple": 1, "participants": 3 }'
refused "an invalid scene" 3 'participants' report "$tmp/bad.json" -o "$tmp/r.html"

# audit
"$crumple" run "$tmp/wall.json" -o "$tmp/result.json"
"$crumple" run "$tmp/wall.json" --trace -o "$tmp/trace.json"
run audit "$tmp/result.json" "$tmp/wall.json"
same "audit finds the same bytes" "$status $out" "0 same bytes"
run audit "$tmp/trace.json" "$tmp/wall.json"
same "with its time series too" "$status $out" "0 same bytes"
run audit "$tmp/result.json"
same "audit of a result alone" "$status$(printf '%s' "$out" | cut -c 1-11)" "0same values"
sed 's/"delta_v_kmh":\([[:space:]]*\)[0-9]/"delta_v_kmh":\19/' "$tmp/result.json" \
    >"$tmp/changed.json"
run audit "$tmp/changed.json" "$tmp/wall.json"
same "a changed number is found" "$status" 1
has "by its place" "$out" 'differs first at /.*delta_v_kmh'
has "and nothing else is blamed" "$out" 'the file was changed'
run audit "$tmp/result.json" "$tmp/wall.json" --set A.speed_kmh=51
has "another input is named" "$out" 'the scene differs'
sed 's/"version":\([[:space:]]*\)"[^"]*"/"version":\1"0.0.9"/' "$tmp/result.json" >"$tmp/old.json"
run audit "$tmp/old.json" "$tmp/wall.json"
has "another version is named" "$out" 'the file is of 0.0.9'
sed 's/\(compact[^"]* sha256 \)[0-9a-f]\{8\}/\100000000/' "$tmp/result.json" >"$tmp/model.json"
run audit "$tmp/model.json" "$tmp/wall.json"
has "other models are named" "$out" 'the models differ'
sed 's/\("irf_sha256":[[:space:]]*"\)[0-9a-f]\{8\}/\100000000/' "$tmp/result.json" >"$tmp/irf.json"
run audit "$tmp/irf.json" "$tmp/wall.json"
has "other risk functions are named" "$out" 'the risk functions differ'
refused "a scene is no result" 3 'no result of crumple run' audit "$tmp/wall.json"
scene torn.json '{ "crumple_result": 2,'
refused "a torn result" 3 'torn.json:' audit "$tmp/torn.json"

# ---- origins, hashes, measured damage ----

cat >"$tmp/car.json" <<'END'
{"crumple": 1, "name": "imported", "source": {"format": "csv", "file": "crashes.csv", "case": "7"},
 "participants": [{"id": "A", "kind": "vehicle", "car": "Fiat 500 Hatchback 2014",
 "position_m": [0, 0], "speed_kmh": 50},
 {"id": "W", "kind": "object", "shape": "wall", "position_m": [4, 0], "heading_deg": 180}]}
END
cat >"$tmp/measured.json" <<'END'
{"crumple_damage": 1, "vehicles": [{"id": "A", "type": "compact", "mass_kg": 1400,
 "damage": {"face": "front", "field_length_m": 1.2,
 "crush_m": [0.30, 0.35, 0.4, 0.4, 0.35, 0.30]}}]}
END
run report "$tmp/car.json" --draws=0 --no-tests -o "$tmp/car.html" --damage "$tmp/measured.json"
same "a scene of a catalogue car, with measured damage" "$status$errs" 0
car=$(cat "$tmp/car.html")
has "what came from the catalogue, with its row" "$car" \
    '<td>length_m</td>.*<td>catalogue: .*[a-z]\.csv:[0-9]+'
has "what came with the file" "$car" \
    '<td>speed_kmh</td><td>50</td><td>km/h</td><td></td><td>imported'
has "and which file" "$car" '<td>file</td><td>crashes.csv</td>'
has "measured beside computed in the picture" "$car" '<text[^>]*>measured, cm</text>'
has "and in a table with the difference" "$car" \
    '<td>A 1</td><td>-0\.60</td><td>30</td><td>[0-9]+</td>'
has "the hash of the program's data" "$car" 'Program data, SHA-256</td><td>[0-9a-f]{64}<'
commit=$("$crumple" --version | sed -n '1s/.*commit //p')
if [ -n "$commit" ]; then
    has "the commit" "$car" "<td>Commit</td><td>$commit</td>"
else
    skip "the commit" "not built from a checkout"
fi
sed 's/"field_length_m": [0-9.]*,//' "$tmp/measured.json" >"$tmp/other.json"
refused "damage that cannot be drawn" 3 'other.json.*no length of the damaged field' \
    report "$tmp/car.json" --draws=0 --no-tests -o "$tmp/none.html" --damage "$tmp/other.json"
sed 's/"id": "A"/"id": "Z"/' "$tmp/measured.json" >"$tmp/other.json"
refused "damage of a vehicle that is not there" 3 "no vehicle 'Z'" \
    report "$tmp/wall.json" --draws=0 --no-tests -o "$tmp/none.html" --damage "$tmp/other.json"

# ---- what the scene says was measured ----

sed 's/"crumple": 1,/&  "x_expect": {"A": {"delta_v_kmh": 50, "delta_v_left_kmh": 2}},/' \
    "$tmp/wall.json" >"$tmp/expect.json"
run report "$tmp/expect.json" --draws=0 --no-tests -o "$tmp/expect.html"
delta=$("$crumple" run "$tmp/wall.json" |
    sed -n 's/.*"delta_v_kmh":[[:space:]]*\([0-9.]*\).*/\1/p' | head -n 1)
percent=$(awk -v c="$delta" 'BEGIN { printf "%+.1f %%", 100 * (c / 50 - 1) }')
has "measured beside computed, with the difference" "$(cat "$tmp/expect.html")" \
    "<td>A</td><td>delta-v, km/h</td><td>50</td><td>[0-9.]+</td><td>[+]${percent#+}</td>"
has "in its unit where a share says nothing" "$(cat "$tmp/expect.html")" \
    '<td>delta-v left, km/h</td><td>2</td><td>[-0-9.e]+</td><td>-2</td>'
sed -i 's/delta_v_kmh/colour/' "$tmp/expect.json"
run report "$tmp/expect.json" --draws=0 --no-tests -o "$tmp/expect.html"
has "what is no measure is told" "$(cat "$tmp/expect.html")" \
    'class="warning">What the scene says was measured .x_expect. was not compared: .*colour'

# ---- US units: 4.2 m are 13.78 ft, 0.9165 m 3.0069 ft, 50 km/h 31.07 mph ----

run report "$SRC/share/scenes/offset-car.json" --draws=0 --no-tests --units=us -o "$tmp/us.html"
has "a list is converted like its unit" "$(cat "$tmp/us.html")" \
    '<td>position_m</td><td>.13\.78,3\.0069.</td><td>ft</td>'
has "an input keeps four digits" "$(cat "$tmp/us.html")" \
    '<td>speed_kmh</td><td>31\.07</td><td>mph</td>'

# ---- at the prompt ----

type_scene="vehicle A type=compact mass=1400kg speed=50km/h; object W kind=wall;
place W facing A gap=0.1m; save $tmp/typed.json; solve"
run -e "$type_scene" \
    -e "export! report $tmp/typed.html draws=10 tests=off author=\"A. Expert\" lang=de"
same "export report" "$status$errs" 0
has "names the line that repeats it" "$(cat "$tmp/typed.html")" \
    "<pre>crumple report .*typed.json -o .*typed.html --lang=de '--author=A. Expert' --draws=10"
line=$(sed -n "s/^<pre>crumple \(report .*\)<.pre>.*/\1/p" "$tmp/typed.html" | head -n 1)
cp "$tmp/typed.html" "$tmp/first.html"
(eval "\"$crumple\" $line") >"$tmp/errs" 2>&1
cmp "$tmp/typed.html" "$tmp/first.html" >>"$tmp/errs" 2>&1
same "which makes the same bytes" "$?$(cat "$tmp/errs")" 0
run -e "export! report $tmp/none.html"
has "not before it is solved" "$status $errs" '^3 .*nothing has been solved'
run -e "load $tmp/typed.json" -e solve -e "export! report $tmp/none.csv"
has "not in the form of a table" "$errs" 'suffix .txt, .html, .pdf'

# ---- every warning has its German ----

sed 's/"speed_kmh": 50/"speed_kmh": 90/' "$tmp/wall.json" >"$tmp/fast.json"
run report "$tmp/fast.json" --draws=0 --no-tests --lang=de -o "$tmp/fast.html"
has "a warning in German, with its numbers" "$(cat "$tmp/fast.html")" \
    'class="warning">A: Annäherung 90 km/h liegt außerhalb von 38 bis 58 km/h'
if python3 -c '' 2>/dev/null; then
    python3 - "$SRC" <<'END' >"$tmp/errs" 2>&1
import glob, re, sys
text = r'"((?:[^"\\]|\\.)*)"'
table = open(sys.argv[1] + "/src/report/warnings.c").read()
known = {"".join(re.findall(text, m)) for m in re.findall(r"\{((?:" + text + r"\s*)+),", table)
         for m in [m[0]]}
for name in glob.glob(sys.argv[1] + "/src/result/*.c"):
    for m in re.finditer(r'cr_result_warn\(\s*r(?:esult)?,\s*"[^"]*",\s*((?:' + text + r"\s*)+)",
                         open(name).read()):
        english = "".join(re.findall(text, m.group(1)))
        pattern = re.sub(r"%[-+ 0-9.]*[a-z]|%%", "%", english)
        if pattern not in known:
            print("src/report/warnings.c has no German for:", pattern)
END
    same "every warning of the program has German" "$(cat "$tmp/errs")" ''
else
    skip "every warning of the program has German" "no python3"
fi

# shellcheck disable=SC2086
run report "$tmp/result.json" $quicker -o "$tmp/again.html"
has "the report of a result computes it again" "$(cat "$tmp/again.html")" \
    'computed again: the same values'
has "and knows what had been assumed" "$(cat "$tmp/again.html")" \
    '<tr class="assumed"><td>track_m</td>'
# shellcheck disable=SC2086
run report "$tmp/changed.json" $quicker -o "$tmp/again.html"
has "or says that it differs" "$(cat "$tmp/again.html")" 'computed again and differs'
finish
