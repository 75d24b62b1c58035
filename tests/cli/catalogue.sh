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
finish
