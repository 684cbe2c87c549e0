#!/bin/bash
# The shares as tasks of HyperQueue, on workers that are there already: `bash hyperqueue.sh`.
set -u
. ./question.sh
mkdir -p "$OUT"
hq submit --wait --array "1-$SHARES" --cpus 1 --crash-limit 5 --stdout none --stderr none -- \
    "$STICKSLIP" "${QUESTION[@]}" --shard "auto/$SHARES" --out "$OUT" --threads 1 --quiet --resume || exit
"$STICKSLIP" merge "$OUT"
