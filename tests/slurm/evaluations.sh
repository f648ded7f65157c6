#!/bin/sh
# 200 evaluations by a real Slurm (cluster.sh up), with one task cancelled, the node's daemon killed in the middle and the coordinator killed
# once: every evaluation exists once, equal to the local run bit for bit.      sh tests/slurm/evaluations.sh PERCAL
set -eu
percal=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
folder=$(mktemp -d /var/tmp/percal-evaluations-XXXXXX)
cp "$here/plan.toml" "$folder"
cd "$folder"

coordinate() { "$percal" campaign plan.toml --slurm --batch 10 --store there.store --out there --quiet & }
done_so_far() { sqlite3 there.store 'select count(*) from evaluations' 2>/dev/null || echo 0; }
wait_for() { while [ "$(done_so_far)" -lt "$1" ]; do sleep 0.2; done; }

coordinate
wait_for 20
scancel "$(squeue --me --array --noheader --states RUNNING --format %i | head -1)"
echo "a task is cancelled at $(done_so_far) of 200"
wait_for 50
kill -9 %1 2>/dev/null || kill -9 $!
wait || true
echo "the coordinator is killed at $(done_so_far)"
coordinate
wait_for 80
pkill -9 -x slurmd
pkill -9 -f "percal work" || true
echo "the node is lost at $(done_so_far)"
sleep 15
slurmd
scontrol update NodeName="$(hostname -s)" State=RESUME 2>/dev/null || true
wait

"$percal" campaign plan.toml --store here.store --out here --quiet
count=$(done_so_far)
[ "$count" -eq 200 ] || { echo "FAILED: $count evaluations in the store, not 200" >&2; exit 1; }
for store in here there; do
  sqlite3 $store.store "select key, outcome, payload from evaluations order by key" | sed 's/"\(cpu\|wall\)_s[a-z]*":[^,}]*//g' > $store.txt
done
cmp here.txt there.txt || { echo "FAILED: evaluations differ from the local ones" >&2; exit 1; }
left=$(find plan.slurm/done -name '*.json' | wc -l)
[ "$left" -eq 0 ] || { echo "FAILED: $left results were not taken in" >&2; exit 1; }
cd /
rm -rf "$folder"
echo "200 evaluations, each once, equal to the local run bit for bit"
