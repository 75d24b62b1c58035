#!/bin/sh
# crumple catalogue: cars by words, in three forms; what fits none; a scene that names one.
. "$SRC/tests/cli/cli.sh"

run catalogue VW golf 2015
same "words in any case succeed" "$status" 0
has "they lead to the car" "$out" 'Volkswagen Golf Hatchback 2015-2021'
run catalogue --format=csv volkswagen golf hatchback 2015
same "CSV: a header and a row" "$(printf '%s\n' "$out" | wc -l)" 2
has "the header names the columns" "$out" '^make,model,from,to,body,type,curb_kg,length_m'
run catalogue --format=json volkswagen golf hatchback 2015
has "JSON has the source of the row" "$out" '"source":.*CISS'
run catalogue
same "no word: more than 1000 cars" "$(($(printf '%s\n' "$out" | wc -l) > 1000))" 1
run catalogue spaceship
same "none: status 1" "$status" 1
has "and it is said" "$errs" "no car fits 'spaceship'"
run catalogue --format=xml
same "a form that is none: status 2" "$status" 2
cat >"$tmp/car.json" <<'JSON'
{ "crumple": 1, "source": { "format": "by hand", "case": "7" }, "participants": [
  { "id": "A", "kind": "vehicle", "car": "golf 2015", "position_m": [0, 0], "speed_kmh": 50 },
  { "id": "W", "kind": "object", "shape": "wall", "position_m": [3, 0], "heading_deg": 180 } ] }
JSON
run run "$tmp/car.json"
same "a scene that names a car is solved" "$status" 0
has "the kerb mass says its row" "$out" '"A.kerb_mass_kg":.*cars.csv:[0-9]'
has "the mass is told as assumed" "$out" 'mass assumed, 1453 kg'
told=$(printf '%s\n' "$out" | grep -o 'mass assumed' | grep -c .)
same "of the car alone, not of the wall" "$told" 1
has "the source is carried into the result" "$out" '"case":.*"7"'
sed 's/golf 2015/gulf 2015/' "$tmp/car.json" >"$tmp/bad.json"
run run "$tmp/bad.json"
same "a car that is not there: status 3" "$status" 3
has "with its place" "$errs" 'bad.json:2:.*no car of the catalogue'

# ---- tables of registers ----
XDG_DATA_HOME=$tmp/home
export XDG_DATA_HOME
head='"Merk","Handelsbenaming","Datum eerste toelating","Massa ledig voertuig"'
echo "$head"',"Massa rijklaar","Lengte","Breedte","Wielbasis"' >"$tmp/rdw.csv"
cat >>"$tmp/rdw.csv" <<'END'
"VOLKSWAGEN","GOLF","20150314","1165","1265","426","179","262"
"VOLKSWAGEN","GOLF","20151101","1185","1285","426","179","262"
"VOLKSWAGEN","GOLF","20170520","","1325","426","179","262"
"VOLKSWAGEN","GOLF","20170520","1160","1260","26","179","262"
"DACIA","SPRING","20220101","970","1070","373","158","242"
"DACIA","SPRING","20220102","970","1070","373","158","242"
"DACIA","SPRING","2022-03-04","976","1076","373","158","242"
END
run catalogue import --format=rdw "$tmp/rdw.csv"
same "a register becomes a table: status 0" "$status" 0
has "it says where" "$out" "^2 cars in $tmp/home/crumple/catalogue/rdw.csv"
# (1165 + 1185 + 1225) / 3; one of 0.26 m stands alone
has "equal cars are one: mean, least and greatest mass, years" \
    "$(cat "$tmp/home/crumple/catalogue/rdw.csv")" \
    '^VOLKSWAGEN,GOLF,2015,2017,1192,1165,1225,4.260,1.790,,2.620,,,RDW n 3$'
run catalogue spring
has "and is listed" "$out" 'DACIA SPRING 2022 .* 972 kg  3.730 x 1.580 m  RDW n 3'
run run "$tmp/car.json"
has "of two tables the user's own is taken" "$out" 'mass assumed, 1267 kg'
run -e 'vehicle A car="dacia spring"; list'
has "a command has it too" "$out" '972 kg kerb \+ 75 driver, 3.730 x 1.580 m'
cat >"$tmp/cvs.csv" <<'END'
Make;Model;MYR;OL;OW;OH;WB;CW;TWF;TWR;WD
HONDA;CIVIC;2016;463;180;142;270;1247;154,5;156,5;61/39
HONDA;CIVIC;2017;463;180;142;270;1255;154,5;156,5;61/39
END
run catalogue import --format=cvs -o - "$tmp/cvs.csv"
# 39 % of 2.70 m on the rear axle
has "Canadian tables: cm, tracks, weight on the axles" "$out" \
    '^HONDA,CIVIC,2016,2017,1251,1247,1255,4.630,1.800,1.420,2.700,1.555,1.053,CVS n 2$'
cat >"$tmp/eea.csv" <<'END'
Mk,Cn,Year,m (kg),W (mm),At1 (mm),At2 (mm)
RENAULT,ZOE,2020,1577,2588,1511,1510
RENAULT,ZOE,2020,1577,2588,1511,1510
RENAULT,ZOE,2021,1577,2588,1511,1510
END
run catalogue import --format=eea -o "$tmp/eea-table.csv" "$tmp/eea.csv"
has "European ones: running order less the driver" "$(cat "$tmp/eea-table.csv")" \
    '^RENAULT,ZOE,2020,2021,1502,1502,1502,,,,2.588,1.511,,EEA n 3$'
run catalogue import --format=cvs "$tmp/eea.csv"
same "another register: status 3" "$status" 3
has "says what is missing" "$errs" 'eea.csv:1:.*no column make, as tables of CVS have'
sed 's/,1577,/,heavy,/' "$tmp/eea.csv" >"$tmp/text.csv"
run catalogue import --format=eea "$tmp/text.csv"
has "a text for a mass has its place" "$errs" "text.csv:2:18: error: 'heavy'"
run catalogue import "$tmp/rdw.csv"
same "no format: status 2" "$status" 2
has "names them" "$errs" 'import needs --format=cvs.rdw.eea'
run catalogue import --format=rdw
same "no file: status 2" "$status" 2
run catalogue volkswagn golf
same "no car: status 1" "$status" 1
has "the nearest is named" "$errs" "no car fits 'volkswagn golf' .did you mean 'volkswagen'"
run catalogue --format=rdw golf
same "a register is no form of a list" "$status" 2
finish
