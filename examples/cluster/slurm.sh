#!/bin/bash
# The shares as a job array: `sbatch slurm.sh`. Each task has one file; a task that is ended before its time is queued again
# and goes on.
#SBATCH --job-name=stickslip
#SBATCH --array=1-7
#SBATCH --cpus-per-task=1
#SBATCH --time=02:00:00
#SBATCH --signal=TERM@60
#SBATCH --requeue
#SBATCH --output=/dev/null
set -u
cd "${SLURM_SUBMIT_DIR:-.}"
. ./question.sh
# `srun`, so that the signal reaches the program and not only this script.
srun "$STICKSLIP" "${QUESTION[@]}" --shard auto --out "$OUT" --threads "${SLURM_CPUS_PER_TASK:-1}" --quiet --resume
code=$?
# 75: to be continued.
if [ "$code" = 75 ]; then
    scontrol requeue "${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}"
fi
exit "$code"
