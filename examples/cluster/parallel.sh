#!/bin/bash
# The shares by GNU parallel, as many at once as there are cores: `bash parallel.sh`. What was interrupted goes on when the
# script is started again.
set -u
. ./question.sh
mkdir -p "$OUT"
seq "$SHARES" | parallel --joblog "$OUT/joblog" --resume-failed \
    "$STICKSLIP" "${QUESTION[@]}" --shard "{}/$SHARES" --out "$OUT" --threads 1 --quiet --resume || exit
"$STICKSLIP" merge "$OUT"
