#!/bin/sh
# usage: type_list.sh MODELS OUT: writes the header of the vehicle types, one for each recipe of the
# folder MODELS, the lightest first. OUT keeps its time if nothing changes: all would be made anew.
set -eu

# lines "MASS WORD"; the first mass of a recipe is that of its reference vehicle
types=$(for recipe in "$1"/*.json; do
    mass=$(sed -n 's/.*"mass_kg": *\([0-9.]*\).*/\1/p' "$recipe" | head -n 1)
    echo "${mass:?"no mass_kg in $recipe"} $(basename "$recipe" .json)"
done)
printf '%s\n' "$types" | LC_ALL=C sort -n | cut -d ' ' -f 2 | awk '
    {
        name = toupper($0)
        gsub(/-/, "_", name)
        rows = rows sprintf(" \\\n    X(%s, \"%s\")", name, $0)
        words = words (NR > 1 ? ", " : "") $0
    }
    END {
        print "/* The vehicle types, by src/model/type_list.sh from the recipes of models/. */"
        print "#define CR_TYPE_LIST(X)" rows
        print "#define CR_TYPE_WORDS \"" words "\""
    }' >"$2.new"
if cmp -s "$2.new" "$2"; then
    rm "$2.new"
else
    mv "$2.new" "$2"
fi
