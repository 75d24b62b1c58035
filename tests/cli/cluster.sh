#!/bin/sh
# The files for clusters in share/cluster, run for real on this one machine: what comes out is what
# one stack writes.
. "$SRC/tests/cli/cli.sh"

small() {
    printf '{"crumple":1,"name":"s%s",%s"settings":{"voxel_mm":100,"dt_ms":2},' "$1" "$3"
    printf '"participants":[{"id":"A","kind":"vehicle","type":"compact","mass_kg":1400,'
    printf '"position_m":[0,0],"heading_deg":0,"speed_kmh":%s},{"id":"wall","kind":"object",' "$2"
    printf '"shape":"wall","position_m":[4,0],"heading_deg":180}]}\n'
}
cd "$tmp" || exit 99
mkdir scenes
for i in 1 2 3 4 5 6 7; do
    small "a$i" $((30 + i)) "\"pair\":\"p$i\","
    small "b$i" $((25 + i)) "\"pair\":\"p$i\","
done >scenes/pairs.jsonl
small last 40 '' >scenes/z.json
CRUMPLE=$crumple
export CRUMPLE
run stack scenes -o all
same "one stack" "$status" 0

if command -v parallel >/dev/null 2>&1 && parallel --version 2>/dev/null | grep -q '^GNU'; then
    SHARDS=4 sh "$SRC/share/cluster/parallel.sh" par scenes >log 2>&1
    same "GNU parallel" "$?:$(cksum <par)" "0:$(cksum <all)"
    explain <log
    same "leaves nothing beside it" "$(echo par*)" par
    # the second shard was stopped before
    "$crumple" stack --shard 2/3 scenes -o again.2
    head -n 2 again.2 >again.2.part
    rm again.2
    SHARDS=3 sh "$SRC/share/cluster/parallel.sh" again scenes >log 2>&1
    same "GNU parallel goes on with what was stopped" "$?:$(cksum <again)" "0:$(cksum <all)"
    explain <log
    CRUMPLE=$tmp/gone SHARDS=2 sh "$SRC/share/cluster/parallel.sh" none scenes >log 2>&1
    has "which fails where nothing comes out" "$?$(cat log)" 'not all shards are through'
else
    skip "GNU parallel" "not installed here (Debian package parallel)"
fi
sh "$SRC/share/cluster/parallel.sh" out >log 2>&1
has "scenes are asked for" "$?$(cat log)" '^2parallel.sh: scenes are wanted'

# a controller, a node and munge of our own on the loopback interface
why=
for command in slurmctld slurmd sbatch munged; do
    command -v $command >/dev/null 2>&1 || why="no $command here (Debian packages slurm-wlm, munge)"
done
[ -n "$why" ] || [ "$(id -u)" -eq 0 ] || why="slurmd and munge are started by root alone"
[ -n "$why" ] || ! pgrep -x 'slurmctld|slurmd' >/dev/null 2>&1 || why="a Slurm is running here"
if [ -n "$why" ]; then
    skip "Slurm job array" "$why"
    finish
fi
host=$(hostname -s)
mkdir -p slurm/state slurm/spool slurm/munge
chmod 755 "$tmp"
cat >slurm/slurm.conf <<END
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$tmp/slurm/munge/socket
StateSaveLocation=$tmp/slurm/state
SlurmdSpoolDir=$tmp/slurm/spool
SlurmctldPidFile=$tmp/slurm/ctld.pid
SlurmdPidFile=$tmp/slurm/d.pid
SlurmctldPort=16817
SlurmdPort=16818
SlurmctldLogFile=$tmp/slurm/ctld.log
SlurmdLogFile=$tmp/slurm/d.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SwitchType=switch/none
MpiDefault=none
NodeName=$host CPUs=$(nproc) State=UNKNOWN NodeAddr=127.0.0.1
PartitionName=p Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
SLURM_CONF=$tmp/slurm/slurm.conf
export SLURM_CONF
pids=
stop() {
    for pid in $pids; do
        kill "$pid" 2>/dev/null
    done
    wait 2>/dev/null
    cd / && rm -rf "$tmp"
}
trap stop EXIT
dd if=/dev/urandom of=slurm/key bs=1 count=1024 2>/dev/null
chmod 400 slurm/key
chmod 711 slurm/munge
munged --foreground --force --key-file="$tmp/slurm/key" --socket="$tmp/slurm/munge/socket" \
    --pid-file="$tmp/slurm/munge/pid" --log-file="$tmp/slurm/munge/log" \
    --seed-file="$tmp/slurm/munge/seed" >slurm/munged.out 2>&1 &
pids="$pids $!"
sleep 1
slurmctld -D -i -f "$SLURM_CONF" >slurm/ctld.out 2>&1 &
pids="$pids $!"
slurmd -D -f "$SLURM_CONF" -N "$host" >slurm/d.out 2>&1 &
pids="$pids $!"
up=
for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15; do
    up=$(timeout 5 sinfo -h -o %T 2>/dev/null)
    [ "$up" = idle ] && break
    sleep 1
done
if [ "$up" != idle ]; then
    skip "Slurm job array" "Slurm does not come up in this container"
    tail -n 4 slurm/*.out slurm/*.log 2>/dev/null | explain
    finish
fi
timeout 120 sbatch --wait --array=1-4 "$SRC/share/cluster/slurm-array.sbatch" sl scenes >log 2>&1
same "a Slurm job array" "$?" 0
explain <log
run merge sl.1 sl.2 sl.3 sl.4
same "makes what one stack writes" "$status:$(cksum <"$tmp/out")" "0:$(cksum <all)"
finish
