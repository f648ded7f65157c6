#!/bin/sh
# A Slurm of one machine, without systemd, as root:   sh tests/slurm/cluster.sh up | down
# Packages: sh tools/setup.sh slurm. For tests alone: it overwrites /etc/slurm and the key of munge.
set -eu
state=/var/tmp/percal-slurm

up() {
  mkdir -p "$state/ctld" "$state/d" "$state/log" /etc/slurm
  install -d -m 0755 -o munge -g munge /run/munge
  install -d -m 0700 -o munge -g munge /etc/munge /var/lib/munge /var/log/munge
  head -c 1024 /dev/urandom > "$state/key"
  install -m 0400 -o munge -g munge "$state/key" /etc/munge/munge.key
  rm "$state/key"
  runuser -u munge -- munged --force
  cat > /etc/slurm/slurm.conf <<CONF
ClusterName=percal
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
StateSaveLocation=$state/ctld
SlurmdSpoolDir=$state/d
SlurmctldPidFile=$state/slurmctld.pid
SlurmdPidFile=$state/slurmd.pid
SlurmctldLogFile=$state/log/slurmctld.log
SlurmdLogFile=$state/log/slurmd.log
SlurmdTimeout=10
SchedulerParameters=defer,sched_min_interval=0,batch_sched_delay=0,sched_interval=1,bf_interval=1
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=2000
PartitionName=main Nodes=$(hostname -s) Default=YES MaxTime=INFINITE State=UP
CONF
  echo "CgroupPlugin=cgroup/v1" > /etc/slurm/cgroup.conf
  slurmctld
  slurmd
  for _ in $(seq 60); do
    if sinfo --noheader --format %T 2>/dev/null | grep -q '^idle'; then
      echo "cluster: up"
      return
    fi
    sleep 1
  done
  echo "cluster: no idle node after a minute; see $state/log" >&2
  exit 1
}

down() {
  pkill -x slurmd || true
  pkill -x slurmctld || true
  pkill -x munged || true
  sleep 1
  rm -rf "$state" /etc/slurm/slurm.conf /etc/slurm/cgroup.conf
  echo "cluster: down"
}

case "${1:-}" in
  up) up ;;
  down) down ;;
  *) echo "usage: $0 up|down" >&2; exit 2 ;;
esac
