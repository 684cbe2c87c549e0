#!/bin/bash
# The same map by one run, by GNU parallel, by the ranks of an MPI job and by a Slurm array, all on this machine, compared
# byte by byte. As root of a Debian machine; Slurm is started here for the time that it takes, and only what is started here
# is ended.
#   STICKSLIP=/path/to/stickslip bash same_bytes.sh
set -eu
here=$(cd "$(dirname "$0")" && pwd)
export STICKSLIP=${STICKSLIP:-$(command -v stickslip)}
command -v sbatch parallel munged > /dev/null ||
    apt-get install -y --no-install-recommends slurmctld slurmd slurm-client munge parallel
command -v mpirun mpicc clang > /dev/null ||
    apt-get install -y --no-install-recommends openmpi-bin libopenmpi-dev libclang-dev clang
work=$(mktemp -d)
cp "$here"/*.sh "$work"
cargo build --release --quiet --manifest-path "$here/mpi/Cargo.toml" --target-dir "$work/mpi"
export STICKSLIP_MPI=$work/mpi/release/stickslip-mpi
cd "$work"
. ./question.sh

"$STICKSLIP" "${QUESTION[@]}" --out one --quiet > one.txt
OUT=by-parallel bash parallel.sh > by-parallel.txt
# As root, and with more ranks than cores.
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 MPIRUN_OPTIONS=--oversubscribe OUT=by-mpi bash mpi.sh > by-mpi.txt

mkdir state spool
name=$(hostname -s)
cat > slurm.conf <<CONF
ClusterName=one
SlurmctldHost=$name(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
NodeName=$name NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
export SLURM_CONF=$work/slurm.conf
mkdir -p /run/munge && chown munge: /run/munge
started=()
trap 'kill "${started[@]}" 2> /dev/null || true' EXIT
if [ ! -S /run/munge/munge.socket.2 ]; then
    runuser -u munge -- munged --foreground 2> /dev/null & started+=($!)
    sleep 1
fi
slurmctld -D 2> /dev/null & started+=($!)
slurmd -D 2> /dev/null & started+=($!)
until sinfo --noheader -o %t | grep -q idle; do sleep 1; done
OUT=by-slurm sbatch --wait slurm.sh
"$STICKSLIP" merge by-slurm --quiet > by-slurm.txt
"$STICKSLIP" status by-slurm

for way in by-parallel by-mpi by-slurm; do
    for file in map.csv map.json map.svg; do
        cmp "one/$file" "$way/$file"
    done
done
echo "the same bytes four ways: $(wc -l < one/map.csv) lines, in $work"
