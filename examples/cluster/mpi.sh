#!/bin/bash
# The shares as the ranks of one MPI job, put together when all are done: `bash mpi.sh`. What was interrupted goes on when the
# script is started again. `stickslip-mpi` is built by `cargo build --release --manifest-path mpi/Cargo.toml`.
set -u
. ./question.sh
RANKS=${STICKSLIP_MPI:-stickslip-mpi}
mpirun -n "$SHARES" ${MPIRUN_OPTIONS:-} "$RANKS" "$STICKSLIP" "${QUESTION[@]}" --out "$OUT"
