#!/bin/sh
# Lesson 8: from a database of accidents to a table of how severe they were.
#
# Run it where crumple is installed: sh 8-from-a-database.sh. It writes into a folder of its own,
# which it removes at the end.
here=$(cd "$(dirname "$0")" && pwd) || exit 2
crumple=${CRUMPLE:-crumple}
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 2

# show COMMAND: print it as it would be typed, then do it
show() {
    printf '\n$ %s\n' "$*"
    eval "$(printf '%s\n' "$*" | sed "s|crumple |\"\$crumple\" |g; s|accidents|\"\$here\"/accidents|")"
}

cat <<'END'
The folder accidents holds four accidents as GIDAS has them, a pre-crash matrix (PCM): one CSV file
for each table, as mdb-export writes them of an Access file. import makes scenes of them, one per
line. One of the four is with a pedestrian: that is told, and its place is kept.
END
show "crumple import accidents -o scenes.jsonl"

cat <<'END'

Each scene says where it is from, down to the SHA-256 of the file:
END
show "head -n 1 scenes.jsonl | grep -o '\"source\":{[^}]*}'"

cat <<'END'

stack solves them all, on every processor, one result per line in the same order. What import said of
the case that is no crash of cars goes on into the results.
END
show "crumple stack scenes.jsonl -o results.jsonl"

cat <<'END'

And as a table: the speeds at the first contact, EES and delta-v.
END
show "crumple stack scenes.jsonl --format csv --fields P1.ees_kmh,P1.delta_v_kmh,P2.ees_kmh,P2.delta_v_kmh"

cat <<'END'

Accidents 101 and 102 are the same, but for a driver who brakes in 102: compare their rows. One case
alone is had with --case:
END
show "crumple import accidents --case 102 | crumple stack - | wc -l"
