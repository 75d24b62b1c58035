# shellcheck shell=sh
# OpenSCENARIO, SUMO and CommonRoad; sourced by import.sh. A build without expat says so.
if ! "$CRUMPLE" --version | grep -q ', expat '; then
    for f in minimal.xosc sumo-fcd.xml commonroad.xml; do
        refused "$f without expat" 2 'made without expat.*libexpat1-dev' "$data/$f"
    done
    skip "samples of XML: this build was made without expat"
else

sample xosc "$data/minimal.xosc"
sample paths "$data/paths.xosc"
sample sumo-collisions "$data/sumo-collisions.xml"
sample sumo-fcd "$data/sumo-fcd.xml"
sample commonroad "$data/commonroad.xml"

# what the reference converters of the samples give: they take SUMO's and CommonRoad's middle for
# the CG
parts() {
    printf '%s\n' "$out" | tr '{' '\n' >"$tmp/parts"
    sed -n 's/.*"id":"\([^"]*\)".*"position_m":\(\[[^]]*\]\).*/\1 \2/p
        s/.*"t_s":\([^,]*\),"x_m":\([^,]*\),"y_m":\([^,]*\),.*/\1 \2 \3/p' "$tmp/parts"
}
run import --reference cg "$data/sumo-collisions.xml"
same "SUMO with the middle as the CG: the places of the reference" "$(parts)" \
    "$(printf 'a [83.95,50]\nb [103.1,39.95]')"
run import --reference cg "$data/commonroad.xml"
same "CommonRoad with the middle as the CG: the places of the reference" "$(parts)" \
    "$(printf '0 0 0\n0.1 1.5 0\n0 8 0.5\n0.1 6.8 0.5')"

# the arc of paths.xosc: radius 20 m about (14, -20), 10 m/s; the rear axle is 1.62 m behind the CG
run import --before 100 "$data/paths.xosc"
number='\([^,]*\)'
row="\"t_s\":$number,\"x_m\":$number,\"y_m\":$number,\"heading_deg\":$number,.*"
printf '%s\n' "$out" | sed 's/.*"id":"B"//; s/"id":"lamp".*//' | tr '{' '\n' |
    sed -n "s/$row/\\1 \\2 \\3 \\4/p" |
    awk '{ rad = 3.141592653589793 / 180
           x = $2 - 1.62 * cos($4 * rad) - 14; y = $3 - 1.62 * sin($4 * rad) + 20
           a = 10 * $1 / 20; e = (x - 20 * cos(a)) ^ 2 + (y - 20 * sin(a)) ^ 2
           d = $4 - 90 - a / rad
           if (e > 1e-6 || d * d > 1e-5) bad++ }
         END { exit !(NR > 20 && bad == 0) }'
same "a clothoid without change of curvature is an arc, to 1 mm" $? 0

for f in xosc paths sumo-collisions; do
    "$CRUMPLE" stack "$data/$f.jsonl" >"$tmp/results" 2>&1
    same "$f solves" $? 0
done

# without NAME SED FILE PATTERN: the file less what the script takes away is refused by one line
without() {
    sed "$2" "$3" >"$tmp/less.xml"
    refused "$1" 1 "less.xml:[0-9]+: error: .*$4" "$tmp/less.xml"
    has "and gives an error object in its place" "$out" '^\{"crumple_result":2,.*"error"'
}
for a in x y; do
    without "WorldPosition without $a" "s/<WorldPosition $a=\"[0-9.]*\"/<WorldPosition/
        s/\\(<WorldPosition.*\\) $a=\"[0-9.]*\"/\\1/" "$data/minimal.xosc" \
        "<WorldPosition>: no \"$a\""
done
for a in length width height; do
    without "no $a" "s/\\(<Dimensions.*\\)$a=\"[0-9.]*\"/\\1/" "$data/minimal.xosc" \
        "<Dimensions>: no \"$a\""
done
without "no positionX" \
    's/\(<FrontAxle.*\)positionX="[0-9.]*"\( positionZ="[0-9.]*"..<Rear\)/\1\2/' \
    "$data/minimal.xosc" '<FrontAxle>: no "positionX"'
without "no trackWidth" 's/trackWidth="[0-9.]*"//' "$data/minimal.xosc" \
    '<FrontAxle>: no "trackWidth"'
without "no Center" 's/<Center[^>]*>//' "$data/minimal.xosc" '<BoundingBox>: no <Center>'
without "no BoundingBox" '/<BoundingBox>/d' "$data/minimal.xosc" '<Vehicle>: no <BoundingBox>'
without "no place" 's/<TeleportAction>.*<.TeleportAction>//' "$data/minimal.xosc" \
    'no TeleportAction that places "A"'
without "no target of the speed" 's/<AbsoluteTargetSpeed[^>]*>//' "$data/minimal.xosc" \
    'only an AbsoluteTargetSpeed.*esmini'
without "a parameter that is not declared" 's/name="v" parameterType/name="w" parameterType/' \
    "$data/minimal.xosc" 'value: no parameter \$v.*ParameterDeclarations'
without "no entities" '/<Entities>/,/<.Entities>/d' "$data/minimal.xosc" 'no <Entities>'
without "no Init" 's/Init>/Later>/' "$data/minimal.xosc" 'no <Storyboard> with <Init>'
without "a place on a lane" \
    's/<WorldPosition x="12"[^>]*>/<LanePosition roadId="1" laneId="1" s="5"\/>/' \
    "$data/minimal.xosc" '<LanePosition>: only a WorldPosition.*csv_logger'
change='<LateralAction><LaneChangeAction\/><\/LateralAction>'
without "an action of a simulator" \
    "s/<LongitudinalAction>.*<.LongitudinalAction>/$change/" "$data/minimal.xosc" \
    '<LaneChangeAction>: this action needs a simulator'
sed 's/entryName="car"/entryName="bus"/' "$data/paths.xosc" >"$tmp/bus.xosc"
cp -r "$data/catalogs" "$tmp"
refused "no such entry of a catalogue" 1 'bus.xosc:.*no "bus" in a catalogue "VehicleCatalog"' \
    "$tmp/bus.xosc"
cp "$data/paths.xosc" "$tmp/many.xosc"
(cd "$tmp/catalogs" && seq 1000 1500 | sed 's/.*/z&.xosc/' | xargs touch)
refused "more catalogues than are looked at" 3 'catalogs: error: more than 500 files in a folder' \
    "$tmp/many.xosc"
rm "$tmp"/catalogs/z1*
sed 's/SimulationTimeCondition/StoryboardElementStateCondition/' "$data/paths.xosc" \
    >"$tmp/when.xosc"
refused "a condition of a simulator" 1 'when.xosc:.*this condition needs a simulator' \
    "$tmp/when.xosc"
sed 's/<Clothoid curv/<Nurbs curv/; s/<.Clothoid>/<\/Nurbs>/' "$data/paths.xosc" >"$tmp/nurbs.xosc"
refused "a spline" 1 'nurbs.xosc:.*<Nurbs>: this form' "$tmp/nurbs.xosc"
sed 's/time="3"/time="0.5"/' "$data/paths.xosc" >"$tmp/times.xosc"
refused "times that go back" 1 'times.xosc:.*<Vertex>: time must rise' "$tmp/times.xosc"
sed 's/revMajor="1"/revMajor="2"/' "$data/minimal.xosc" >"$tmp/two.xosc"
refused "another language" 3 'two.xosc:3:.*OpenSCENARIO 2.1' "$tmp/two.xosc"

for a in collider victimSpeed colliderFront victimBack; do
    without "SUMO without $a" "s/ $a=\"[^\"]*\"//" "$data/sumo-collisions.xml" \
        "<collision>: no \"$a\""
done
for at in 1 1,2,3,4 1,x '1;2' ,2; do
    without "a place $at" "s/colliderFront=\"[^\"]*\"/colliderFront=\"$at\"/" \
        "$data/sumo-collisions.xml" '<collision>: colliderFront is no place "x,y"'
done
without "a person" 's/victimType="car"/victimType="DEFAULT_PEDTYPE"/' "$data/sumo-collisions.xml" \
    '"b" is not a car'
for a in id x y angle speed; do
    without "fcd without $a" "s/\\(<vehicle.*\\) $a=\"[^\"]*\"/\\1/" "$data/sumo-fcd.xml" \
        "<vehicle>: no \"$a\""
done
without "fcd without time" 's/ time="12.20"//' "$data/sumo-fcd.xml" '<timestep>: no "time"'

without "CommonRoad without timeStepSize" 's/timeStepSize="0.1"//' "$data/commonroad.xml" \
    'no "timeStepSize"'
for e in velocity orientation time; do
    without "CommonRoad without $e" "s/<$e>.*<.$e>//" "$data/commonroad.xml" "no <$e>"
done
without "CommonRoad without x" 's/<x>8<.x>//' "$data/commonroad.xml" '<point>: no <x>'
without "CommonRoad without length" 's/<length>4.1<.length>//' "$data/commonroad.xml" \
    '<rectangle>: no <length>'
sed 's/2020a/2031z/' "$data/commonroad.xml" >"$tmp/version.xml"
run import "$tmp/version.xml"
has "a version of CommonRoad that is not known is told" "$out" \
    '"note":"version ."2031z." of CommonRoad is not known: read as 2020a'
between='<intervalStart>14<\/intervalStart><intervalEnd>16<\/intervalEnd>'
sed "s/<velocity><exact>15<.exact>/<velocity>$between/" \
    "$data/commonroad.xml" >"$tmp/interval.xml"
run import "$tmp/interval.xml"
has "the middle of an interval, with a note" "$out" 'middle of intervals taken.*"speed_kmh":54[,}]'

# ---- hostile files ----
{
    echo '<?xml version="1.0"?><!DOCTYPE fcd-export [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>'
    echo '<fcd-export>&b;</fcd-export>'
} >"$tmp/laughs.xml"
refused "entities" 3 'laughs.xml:1: .*declarations of its own' "$tmp/laughs.xml"
echo '<!DOCTYPE fcd-export SYSTEM "file:///etc/passwd"><fcd-export>&x;</fcd-export>' \
    >"$tmp/outer.xml"
refused "an entity from outside" 3 'outer.xml:1: .*no entity &x;' "$tmp/outer.xml"
{
    echo '<fcd-export>'
    awk 'BEGIN { for (i = 0; i < 200000; i++) printf "<a>" }'
} >"$tmp/deep.xml"
refused "deep nesting" 3 'deep.xml:2: .*nested too deeply' "$tmp/deep.xml"
{
    printf '<fcd-export a="'
    awk 'BEGIN { for (i = 0; i < 300000; i++) printf "0123456789" }'
} >"$tmp/long.xml"
refused "a tag of megabytes" 3 'long.xml:1: .*more than a megabyte' "$tmp/long.xml"
{
    echo '<OpenSCENARIO>'
    awk 'BEGIN { for (i = 0; i < 1100000; i++) print "<a/>" }'
} >"$tmp/many.xosc"
refused "a tree of a million elements" 3 'many.xosc:[0-9]+: .*too large' "$tmp/many.xosc"
rm "$tmp/deep.xml" "$tmp/long.xml" "$tmp/many.xosc"
head -c 900 "$data/minimal.xosc" >"$tmp/cut.xosc"
refused "a file that was cut" 3 'cut.xosc:[0-9]+:[0-9]+: error: no well-formed XML' "$tmp/cut.xosc"
decl='<ParameterDeclaration name="v" parameterType="double" value="$v"/>'
sed "s|<ParameterDeclaration name=\"v\"[^>]*>|$decl|" "$data/minimal.xosc" >"$tmp/round.xosc"
refused "a parameter made of itself" 1 'round.xosc:.*in a circle' "$tmp/round.xosc"
awk '/<ParameterDeclarations>/ {
         print "<ParameterDeclarations>"
         for (i = 0; i < 18; i++) {
             printf "<ParameterDeclaration name=\"p%d\" value=\"${0", i
             for (k = 0; k < 60; k++) printf "+$p%d", i + 1
             print "}\"/>"
         }
         print "<ParameterDeclaration name=\"p18\" value=\"1\"/>"
         print "<ParameterDeclaration name=\"v\" value=\"$p0\"/></ParameterDeclarations>"
         next
     } 1' "$data/minimal.xosc" >"$tmp/laugh.xosc"
refused "parameters that multiply" 1 'laugh.xosc:.*made of each other without end' "$tmp/laugh.xosc"
fi
