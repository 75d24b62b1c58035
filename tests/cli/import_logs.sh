# shellcheck shell=sh
# esmini's two logs and CarMaker's results; sourced by import.sh.
sample esmini-dat2csv "$data/esmini-dat2csv.csv"
sample esmini-log "$data/esmini-log.csv"
sample two-erg "$data/two.erg"

sed 's/, speed, /, pace, /' "$data/esmini-dat2csv.csv" >"$tmp/less.csv"
refused "dat2csv without speed" 1 'less.csv:1:.*speed' "$tmp/less.csv"
for column in 'World_Position_X \[m\]' 'World_Heading_Angle \[rad\]' 'Current_Speed \[m\/s\]' \
    'bb_length \[m\]' 'bb_x \[m\]' 'Entity_Name \[-\]'; do
    sed "s/#2 $column/#2 Other/" "$data/esmini-log.csv" >"$tmp/less.csv"
    case $column in
    World_Position_X*) continue ;; # then there is no second entity
    esac
    refused "log without ${column%% *}" 1 "less.csv:7:.*#2 ${column%% *}" "$tmp/less.csv"
done
sed 's/TimeStamp \[s\]/Other/' "$data/esmini-log.csv" >"$tmp/less.csv"
refused "log without time" 1 'less.csv:7:.*TimeStamp' "$tmp/less.csv"
sed '9s/, 15.000000,/, fast,/' "$data/esmini-log.csv" >"$tmp/text.csv"
refused "log with a text for a number" 1 "text.csv:9:[0-9]+: error: 'fast'" "$tmp/text.csv"

# one car alone is no crash; with a wall of the user's own it is
refused "one car alone" 1 'mini.erg: error: a crash needs two participants' "$data/mini.erg"
sample mini-erg --map "$data/wall-map.json" "$data/mini.erg"

run import "$data/two.erg.info"
same "the description leads to the records" \
    "$(printf '%s\n' "$out" | sed 's/.*"participants"//')" \
    "$(sed 's/.*"participants"//' "$data/two-erg.jsonl")"
cp "$data/two.erg" "$tmp"
refused "records without description" 2 'two.erg.info: .*cannot open.*belong together' \
    --format erg "$tmp/two.erg"
# less SED PATTERN STATUS: two.erg with a description that was changed
less() {
    sed "$2" "$data/two.erg.info" >"$tmp/two.erg.info"
    refused "$1" "$4" "two.erg.info:.*$3" "$tmp/two.erg"
}
less "no byte order" '/ByteOrder/d' 'no File.ByteOrder' 3
less "an unknown byte order" 's/BigEndian/Middle/' '4: .*neither LittleEndian' 3
less "another format" 's/= erg/= ascii/' '3: .*only the format erg' 3
less "an unknown type" 's/= Short/= Quad/' 'File.At.9.Type: unknown type: "Quad"' 3
less "a type missing" '/File.At.3.Type/d' 'each with a type' 3
for q in Time Car.Fr1.tx Car.Fr1.ty Car.Yaw Traffic.T00.ty Traffic.T00.rz Traffic.T00.LongVel; do
    less "no $q" "s/= $q\$/= Other/" "no quantity $q" 1
done
less "a unit of something else" 's/Yaw.Unit = rad/Yaw.Unit = kg/' 'Car.Yaw: the unit "kg"' 1
cp "$data/two.erg.info" "$tmp"
head -c 700 "$data/two.erg" >"$tmp/two.erg"
refused "records that were cut" 1 'two.erg: .*record [0-9]+ has [0-9]+ bytes' "$tmp/two.erg"
