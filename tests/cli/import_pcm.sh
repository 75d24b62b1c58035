# shellcheck shell=sh
# PCM databases of both generations, as SQLite and as folders of CSV; sourced by import.sh.
if "$CRUMPLE" --version | grep -q 'no SQLite'; then
    skip "PCM databases" "this build has no SQLite"
    refused "without SQLite it is said" 2 'pcm5.db: error: .*libsqlite3-dev' "$data/pcm5.db"
else
    parts='s/.*"participants"//'
    sample pcm5 "$data/pcm5.db"
    for folder in pcm5 pcm4; do
        sample "$folder-folder" "$data/$folder"
        same "folder of CSV, $folder: the same participants" \
            "$(printf '%s\n' "$out" | sed "$parts")" "$(sed "$parts" "$data/pcm5.jsonl")"
    done
    for column in participant_data:CASEID participant_data:PARTID participant_data:PARTTYPE \
        dynamics:CASEID dynamics:PARTID dynamics:TIME dynamics:POSX dynamics:POSY \
        dynamics:POSPSI dynamics:VX dynamics:VY; do
        rm -rf "$tmp/less"
        cp -r "$data/pcm5" "$tmp/less" && chmod -R u+w "$tmp/less"
        sed "1s/${column#*:}/OTHER/" "$data/pcm5/${column%:*}.csv" >"$tmp/less/${column%:*}.csv"
        refused "without ${column#*:} of ${column%:*}" 3 \
            "less: error: table ${column%:*} has no column ${column#*:}" "$tmp/less"
    done
    # what need not be there may be there under a name that is misspelt
    for column in participant_data:WEIGHT:WIEGHT participant_data:COGZ:COG_Z dynamics:MUE:MU; do
        table=${column%%:*} right=${column#*:} wrong=${column##*:}
        right=${right%:*}
        rm -rf "$tmp/less"
        cp -r "$data/pcm5" "$tmp/less" && chmod -R u+w "$tmp/less"
        sed "1s/$right/$wrong/" "$data/pcm5/$table.csv" >"$tmp/less/$table.csv"
        run import "$tmp/less"
        has "$wrong for $right is told" "$out" \
            "\"note\":\"no $right in $table: is .\"$wrong.\" meant, which is not read"
    done
    rm "$tmp/less/dynamics.csv"
    refused "without dynamics" 3 'less: error: table dynamics is not there' "$tmp/less"
    sed '3s/7.5,0.0/,0.0/' "$data/pcm5/dynamics.csv" >"$tmp/less/dynamics.csv"
    refused "an empty POSX" 1 'dynamics: POSX of participant P?1 is empty at TIME 0.5' "$tmp/less"
    has "gives an error object" "$out" '^\{"crumple_result":2,"scene":"pcm-1000001","error"'
    cp "$data/pcm5/dynamics.csv" "$tmp/less/dynamics.csv"
    sed '3s/1000001,2,0,/1000001,2,1,/' "$data/pcm5/participant_data.csv" \
        >"$tmp/less/participant_data.csv"
    refused "a pedestrian" 1 'participant P?2 is a pedestrian, not a car' "$tmp/less"
    sed '2s/1420.0/heavy/' "$data/pcm5/participant_data.csv" >"$tmp/less/participant_data.csv"
    refused "a text for a mass" 1 \
        'participant_data: WEIGHT of participant 1 is no number: "heavy"' "$tmp/less"
    sed '1!s/,0.8$/,wet/' "$data/pcm5/dynamics.csv" >"$tmp/less/dynamics.csv"
    cp "$data/pcm5/participant_data.csv" "$tmp/less"
    refused "a text for a friction" 1 'dynamics: MUE of participant 1 is no number: "wet"' \
        "$tmp/less"
    { cat "$data/pcm5/dynamics.csv"; echo 77,1,0,0,0,0,9,0,0,0,0.8; } >"$tmp/less/dynamics.csv"
    refused "a case of dynamics alone" 1 'participant_data has no participant of this case' \
        "$tmp/less"
    same "the others come out" "$(printf '%s\n' "$out" | grep -c '"name":"pcm-1000001"')" 1
    # a second case, one of which is asked for, and one is at fault
    for table in participant_data participant_shape dynamics; do
        sed 1d "$data/pcm5/$table.csv" | sed 's/^1000001/7/' | cat "$data/pcm5/$table.csv" - \
            >"$tmp/less/$table.csv"
    done
    run import --case 7 "$tmp/less"
    same "--case: one of two" "$(printf '%s\n' "$out" | grep -o '"name":"[^"]*"')" '"name":"pcm-7"'
    # the lesson: four accidents, one of them with a pedestrian, up to the table of their severities
    lesson=$(sh "$SRC/share/tutorial/8-from-a-database.sh" 2>&1)
    same "the lesson from a database to a stack: status" "$?" 0
    solved='^[0-2],pcm-10[1-3],,[0-9.]+,[0-9.]+,[0-9.]+,[0-9.]+,$'
    same "three accidents have EES and delta-v" "$(printf '%s\n' "$lesson" | grep -cE "$solved")" 3
    has "what import said of the fourth goes on through the stack" "$lesson" \
        '^3,pcm-104,,,,,,"?participant 2 is a pedestrian'
    same "and the last command gives one result" "$(printf '%s\n' "$lesson" | tail -n 1)" 1
    head -c 9000 "$data/pcm5.db" >"$tmp/cut.db"
    refused "a database that is cut off" 3 'cut.db: error: ' "$tmp/cut.db"
    # a database computes nothing: it could without end, or fill the disk with what it sorts
    if python3 -c 'import sqlite3' 2>/dev/null; then
        # made SQL: the database of the sample changed so
        made() {
            cp "$data/pcm5.db" "$tmp/made.db"
            python3 -c 'import sqlite3, sys
d = sqlite3.connect(sys.argv[1])
d.executescript(sys.argv[2])
d.commit()' "$tmp/made.db" "$1"
        }
        plain='is no plain table: the database computes it'
        kept='ALTER TABLE dynamics RENAME TO kept'
        made "$kept; CREATE VIEW dynamics AS SELECT * FROM kept"
        refused "a view" 3 "made.db: error: dynamics $plain" "$tmp/made.db"
        endless='WITH RECURSIVE r(n) AS (SELECT 0 UNION ALL SELECT n + 1 FROM r)'
        made "$kept; CREATE VIEW dynamics AS $endless SELECT kept.* FROM kept, r"
        refused "a view without end" 3 "dynamics $plain" "$tmp/made.db"
        shape='ALTER TABLE participant_shape RENAME TO s; CREATE TABLE participant_shape'
        made "$shape(CASEID, X, PARTID AS (zeroblob(9000000))); INSERT INTO participant_shape
            SELECT CASEID, X FROM s"
        refused "a computed column" 3 "participant_shape $plain" "$tmp/made.db"
        made "CREATE VIEW other AS SELECT 1; CREATE INDEX i ON dynamics(CASEID)"
        run import "$tmp/made.db"
        same "what is not read may be a view" "$status" 0
        # 3000 cases in tables that are said to have one row each: SQLite looks through all for each
        bomb=$(for table in participant_data participant_shape dynamics; do
            rest=$(sed -n '1{s/^CASEID,//;s/\r//;p;}' "$data/pcm5/$table.csv")
            echo "INSERT INTO $table SELECT n + 2, $rest FROM $table,
                (WITH RECURSIVE r(n) AS (SELECT 0 UNION ALL SELECT n + 1 FROM r LIMIT 3000)
                SELECT n FROM r);"
        done)
        made "$bomb"
        run import --case 7 "$tmp/made.db"
        same "many cases are read" "$status" 0
        made "CREATE TABLE x(y); ANALYZE; DELETE FROM sqlite_stat1; $bomb INSERT INTO sqlite_stat1
            VALUES ('participant_data', NULL, '1'), ('participant_shape', NULL, '1'),
            ('dynamics', NULL, '1')"
        refused "statistics that mislead" 4 'made.db: error: too expensive' "$tmp/made.db"
    else
        skip "a database computes nothing" "no python3 with sqlite3"
    fi
fi
