# shellcheck shell=sh
# Archives, and folders with one file of a format; sourced by import.sh.
mkdir "$tmp/folder"
cp "$data/vtv.EV5" "$data/vtv.008" "$data/vtv.009" "$tmp/folder"
run import "$tmp/folder"
same "a folder with one test in it: the scene of the test" "$out" "$(cat "$data/vtv.jsonl")"
cp "$data/long.csv" "$tmp/folder"
refused "a folder with two files that import knows" 3 'folder: error: .*several.*name those' \
    "$tmp/folder"

if "$CRUMPLE" --version | grep -q 'no libzip'; then
    refused "without libzip it is said" 2 'wall.zip: error: .*libzip-dev' "$data/wall.zip"
    skip "archives: this build has no libzip"
else
    mkdir "$tmp/own"
    TMPDIR=$tmp/own
    export TMPDIR
    sample wall-zip "$data/wall.zip"
    parts='s/.*"participants"//'
    same "an archive has the participants of its folder" \
        "$(printf '%s\n' "$out" | sed "$parts")" "$(sed "$parts" "$data/wall-mme.jsonl")"
    has "and the SHA-256 of itself" "$out" "$(sha256sum "$data/wall.zip" | cut -c1-64)"
    out=$("$CRUMPLE" import - <"$data/wall.zip")
    same "from standard input it is the same" "$(printf '%s\n' "$out" | sed "$parts")" \
        "$(sed "$parts" "$data/wall-mme.jsonl")"
    head -c 1000 "$data/wall.zip" >"$tmp/cut.zip"
    refused "an archive that was cut" 3 'cut.zip: error: no whole archive' "$tmp/cut.zip"
    if python3 -c 'import zipfile' 2>/dev/null; then
        python3 - "$tmp" "$data/vtv.EV5" <<'END'
import sys, zipfile
def archive(name):
    return zipfile.ZipFile(sys.argv[1] + "/" + name, "w", zipfile.ZIP_DEFLATED)
with archive("slip.zip") as z:
    z.writestr("../slipped.csv", "t,id\n")
with archive("zeros.zip") as z:
    z.writestr("zeros.csv", b"0" * 120000000)
with archive("text.zip") as z:
    z.writestr("readme", "nothing of the kind\n")
with archive("test.zip") as z:
    z.write(sys.argv[2], "deep/er/vtv.EV5")
    z.writestr("deep/er/vtv.008", "0\t1\noops\n")
END
        refused "a name that leads out" 3 'slip.zip: error: .*leads out.*\.\./slipped' \
            "$tmp/slip.zip"
        same "and nothing came out" "$(find "$tmp" -name slipped.csv | wc -l)" 0
        refused "a hundred megabytes of zeros" 3 'zeros.zip: error: .*holds too much' \
            "$tmp/zeros.zip"
        refused "an archive of other things" 3 'text.zip: error: no format' "$tmp/text.zip"
        refused "a fault in it has its place in it" 1 \
            "test.zip/deep/er/vtv.008:2: error: no sample" "$tmp/test.zip"
    else
        skip "hostile archives: no python3 makes them"
    fi
    same "nothing is left of what was unpacked" "$(find "$tmp/own" -mindepth 1 | wc -l)" 0
    unset TMPDIR
fi
