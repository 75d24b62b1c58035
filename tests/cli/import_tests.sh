# shellcheck shell=sh
# Crash tests: NHTSA's EV5 with channels, ISO-MME; sourced by import.sh.
sample ev5 "$data/mini.EV5"
sample vtv "$data/vtv.EV5"
sample pole "$data/pole.EV5"
sample wall-mme "$data/wall.mme"
for f in ev5 pole wall-mme; do
    "$CRUMPLE" stack "$data/$f.jsonl" >"$tmp/results" 2>&1
    same "$f solves" $? 0
done
run import "$data/wall.mme/wall.mme"
same "the .mme in the folder gives the same scene" \
    "$(printf '%s\n' "$out" | sed 's/.*"participants"//')" \
    "$(sed 's/.*"participants"//' "$data/wall-mme.jsonl")"

# -20 g over 0.1 s and a ramp of 10 ms: 20 g x 0.105 s; 5 g to the right
has "delta-v is the integral of the channels" "$(cat "$data/vtv.jsonl")" \
    '"delta_v_forward_kmh":-74.14,"delta_v_left_kmh":-18.53'

# the same channels beside the solved test, as they lie and by the test
head -n 1 "$data/vtv.jsonl" >"$tmp/vtv.json"
for f in vtv.EV5 vtv.008; do
    out=$(printf 'load %s\nsolve\ncompare %s of=V1\n' "$tmp/vtv.json" "$data/$f" |
        "$CRUMPLE" 2>"$tmp/err")
    same "compare $f: status 0" $? 0
    has "channel and sign of $f are told" "$out" 'AC VECG XG of vehicle 1, .*forward positive'
    has "and its peak, -20 g" "$out" 'largest: test -20[. ]'
done
LC_ALL=C sed "s/MADE UP WALL/M$(printf '\374')nchen/; s/^1|/$(printf '\377')1|/" "$data/mini.EV5" \
    >"$tmp/latin.EV5"
run import "$tmp/latin.EV5"
same "Latin-1 in a title and in the number of a vehicle" "$status" 0
printf '%s\n' "$out" | "$CRUMPLE" stack - >"$tmp/results" 2>&1
same "gives a scene that reads" $? 0
has "in UTF-8" "$(printf '%s\n' "$out")" '"x_title":"München TEST"'

# field NAME N VALUE PATTERN: field N of the VEHICLE line of mini.EV5 is replaced
field() {
    awk -F'|' -v OFS='|' -v n="$2" -v to="$3" '/^1.16.03/ { $n = to } 1' "$data/mini.EV5" \
        >"$tmp/less.EV5"
    refused "$1" 1 "less.EV5:6: error: VEHICLE, field $2: $4" "$tmp/less.EV5"
}
field "no test mass" 11 '' 'the test mass is not recorded'
field "a test mass of 0" 11 0 'the test mass is not recorded'
field "no length" 14 0 'the length is not recorded'
field "no width" 15 0 'the width is not recorded'
field "no speed" 42 '' 'the speed is not recorded'
field "a text for a number" 13 long 'no number'
sed 's/VTB/ROL/' "$data/mini.EV5" >"$tmp/less.EV5"
refused "a rollover" 1 'less.EV5:4: error: TEST, field 9: neither' "$tmp/less.EV5"
sed '/^----- VEHICLE/,/^1/d' "$data/mini.EV5" >"$tmp/less.EV5"
refused "no vehicle" 1 'less.EV5: error: no record in section VEHICLE' "$tmp/less.EV5"
sed '/^V5/d' "$data/mini.EV5" >"$tmp/less.EV5"
refused "no test" 3 'less.EV5: error: no record in section TEST' "$tmp/less.EV5"
cp "$data/vtv.EV5" "$data/vtv.009" "$tmp"
sed '5s/.*/oops/' "$data/vtv.008" >"$tmp/vtv.008"
refused "a channel with a text in it" 1 'vtv.008:5: error: no sample: "oops"' "$tmp/vtv.EV5"

# mme SED PATTERN: the folder with a .mme that was changed
mme() {
    rm -rf "$tmp/t"
    cp -r "$data/wall.mme" "$tmp/t"
    sed "$2" "$data/wall.mme/wall.mme" >"$tmp/t/wall.mme"
    refused "$1" 1 "t/wall.mme:(.*)?$3" "$tmp/t"
}
mme "no velocity" '/^Velocity test object 1/d' 'test object 1 .*no "Velocity test object 1"'
mme "no mass" '/^Mass test object 1/d' 'test object 1 .*no "Mass test object 1"'
mme "no number of objects" '/^Number of/d' 'no "Number of test objects"'
mme "a text for a velocity" 's/:15.5/:fast/' '7: error: Velocity test object 1'
mme "a mobile barrier" 's/rigid wall/MPDB/; s/:B$/:M/' 'mobile barrier, of which there is no model'
mme "two vehicles that meet somehow" 's/rigid wall/Other car/; s/:B$/:1/; s/NOVALUE/1400/
    s/object 2      :0/object 2      :15/' 'does not say how two vehicles meet'
rm -rf "$tmp/t" && cp -r "$data/wall.mme" "$tmp/t"
(cd "$tmp/t/Channel" && seq 10001 15001 | sed 's/^/wall./' | xargs touch)
refused "more channels than are looked at" 1 't: error: more than 5000 channels' "$tmp/t"
refused "the demo, which has no velocities" 1 'demo.mme:.*no "Velocity test object 1"' "$data/mme"
rm -rf "$tmp/t"
cp -r "$data/wall.mme" "$tmp/t"
for key in 'Channel code' Unit 'Sampling interval' 'Number of samples' 'Time of first sample'; do
    sed "/^$key /d" "$data/wall.mme/Channel/wall.001" >"$tmp/t/Channel/wall.001"
    refused "a channel without $key" 1 "wall.001: error: no \"$key\"" "$tmp/t"
done
sed 's/^\(Number of samples *:\).*/\10/; /^[-0-9]/d' "$data/wall.mme/Channel/wall.001" \
    >"$tmp/t/Channel/wall.001"
refused "a channel of no samples" 1 'wall.001: error: a channel without samples' "$tmp/t"
sed '$d' "$data/wall.mme/Channel/wall.001" >"$tmp/t/Channel/wall.001"
refused "a channel that was cut" 1 'wall.001:[0-9]+: error: 120 samples' "$tmp/t"
rm "$tmp/t/wall.mme"
refused "a folder without .mme" 3 'no .mme file' --format mme "$tmp/t"
