//! CVODES: BDF with forward sensitivities by the staggered corrector, dense Newton with the exact Jacobian.
//!
//! The few functions of SUNDIALS 6 that this takes are declared here as its headers declare them.

use std::ffi::{c_int, c_long, c_void};
use std::ptr::{null_mut, slice_from_raw_parts, slice_from_raw_parts_mut};

use stickslip::field::{Field, SmoothField};
use stickslip::model::Model;

use crate::round::{Round, Sensitivities};

type Pointer = *mut c_void;
type Rhs = extern "C" fn(f64, Pointer, Pointer, Pointer) -> c_int;
type Jac =
    extern "C" fn(f64, Pointer, Pointer, Pointer, Pointer, Pointer, Pointer, Pointer) -> c_int;
type SensRhs = extern "C" fn(
    c_int,
    f64,
    Pointer,
    Pointer,
    c_int,
    Pointer,
    Pointer,
    Pointer,
    Pointer,
    Pointer,
) -> c_int;

const CV_BDF: c_int = 2;
const CV_STAGGERED: c_int = 2;
const CV_NORMAL: c_int = 1;
const STEPS: c_long = 500_000;

#[allow(non_snake_case)]
unsafe extern "C" {
    fn SUNContext_Create(communicator: Pointer, context: *mut Pointer) -> c_int;
    fn SUNContext_Free(context: *mut Pointer) -> c_int;
    fn N_VNew_Serial(length: i64, context: Pointer) -> Pointer;
    fn N_VCloneVectorArray(count: c_int, like: Pointer) -> *mut Pointer;
    fn N_VGetArrayPointer(vector: Pointer) -> *mut f64;
    fn N_VDestroy(vector: Pointer);
    fn N_VDestroyVectorArray(vectors: *mut Pointer, count: c_int);
    fn SUNDenseMatrix(rows: i64, columns: i64, context: Pointer) -> Pointer;
    fn SUNDenseMatrix_Data(matrix: Pointer) -> *mut f64;
    fn SUNMatDestroy(matrix: Pointer);
    fn SUNLinSol_Dense(vector: Pointer, matrix: Pointer, context: Pointer) -> Pointer;
    fn SUNLinSolFree(solver: Pointer) -> c_int;
    fn CVodeCreate(method: c_int, context: Pointer) -> Pointer;
    fn CVodeInit(memory: Pointer, rhs: Rhs, time: f64, start: Pointer) -> c_int;
    fn CVodeSetErrFile(memory: Pointer, file: Pointer) -> c_int;
    fn CVodeSetUserData(memory: Pointer, data: Pointer) -> c_int;
    fn CVodeSStolerances(memory: Pointer, relative: f64, absolute: f64) -> c_int;
    fn CVodeSetMaxNumSteps(memory: Pointer, steps: c_long) -> c_int;
    fn CVodeSetStopTime(memory: Pointer, time: f64) -> c_int;
    fn CVodeSetLinearSolver(memory: Pointer, solver: Pointer, matrix: Pointer) -> c_int;
    fn CVodeSetJacFn(memory: Pointer, jacobian: Jac) -> c_int;
    fn CVodeSensInit1(
        memory: Pointer,
        count: c_int,
        method: c_int,
        rhs: SensRhs,
        start: *mut Pointer,
    ) -> c_int;
    fn CVodeSensSStolerances(memory: Pointer, relative: f64, absolute: *mut f64) -> c_int;
    fn CVodeSetSensErrCon(memory: Pointer, on: c_int) -> c_int;
    fn CVode(memory: Pointer, until: f64, end: Pointer, time: *mut f64, task: c_int) -> c_int;
    fn CVodeGetSens(memory: Pointer, time: *mut f64, ends: *mut Pointer) -> c_int;
    fn CVodeFree(memory: *mut Pointer);
}

/// Once around; `None` if CVODES gives up.
pub(crate) fn bdf<M: Model<N>, const N: usize>(
    round: &Round<M, N>,
    tolerance: f64,
) -> Option<Sensitivities<N>> {
    let mut field = round.field();
    let columns = N + 1;
    let mut absolute = vec![tolerance; columns];
    // SAFETY: every object is created here, used as the manual of CVODES 6 says, and freed below; the callbacks get
    // vectors of length N and the field that outlives them.
    unsafe {
        let mut context = null_mut();
        if SUNContext_Create(null_mut(), &mut context) != 0 {
            return None;
        }
        let y = N_VNew_Serial(N as i64, context);
        write::<N>(y, round.start);
        let sensitivities = N_VCloneVectorArray(columns as c_int, y);
        for column in 0..columns {
            let unit = std::array::from_fn(|row| f64::from(row == column));
            write::<N>(*sensitivities.add(column), unit);
        }
        let matrix = SUNDenseMatrix(N as i64, N as i64, context);
        let solver = SUNLinSol_Dense(y, matrix, context);
        let mut memory = CVodeCreate(CV_BDF, context);
        let mut time = 0.0;
        let good = [
            CVodeSetErrFile(memory, null_mut()),
            CVodeInit(memory, rhs::<M, N>, 0.0, y),
            CVodeSetUserData(memory, (&raw mut field).cast()),
            CVodeSStolerances(memory, tolerance, tolerance),
            CVodeSetMaxNumSteps(memory, STEPS),
            CVodeSetLinearSolver(memory, solver, matrix),
            CVodeSetJacFn(memory, jacobian::<M, N>),
            CVodeSensInit1(
                memory,
                columns as c_int,
                CV_STAGGERED,
                sensitivity::<M, N>,
                sensitivities,
            ),
            CVodeSensSStolerances(memory, tolerance, absolute.as_mut_ptr()),
            CVodeSetSensErrCon(memory, 1),
            CVodeSetStopTime(memory, round.period),
        ]
        .iter()
        .all(|&code| code == 0)
            && CVode(memory, round.period, y, &mut time, CV_NORMAL) >= 0
            && CVodeGetSens(memory, &mut time, sensitivities) == 0;
        let found = good.then(|| {
            let ends: Vec<[f64; N]> = (0..columns)
                .map(|column| read(*sensitivities.add(column)))
                .collect();
            let state = std::array::from_fn(|i| std::array::from_fn(|j| ends[j][i]));
            (state, ends[N])
        });
        CVodeFree(&mut memory);
        SUNLinSolFree(solver);
        SUNMatDestroy(matrix);
        N_VDestroyVectorArray(sensitivities, columns as c_int);
        N_VDestroy(y);
        SUNContext_Free(&mut context);
        found
    }
}

/// SAFETY: `vector` is a serial vector of length N.
unsafe fn read<const N: usize>(vector: Pointer) -> [f64; N] {
    let entries = unsafe { &*slice_from_raw_parts(N_VGetArrayPointer(vector), N) };
    std::array::from_fn(|j| entries[j])
}

/// SAFETY: as for [`read`].
unsafe fn write<const N: usize>(vector: Pointer, values: [f64; N]) {
    let entries = unsafe { &mut *slice_from_raw_parts_mut(N_VGetArrayPointer(vector), N) };
    entries.copy_from_slice(&values);
}

extern "C" fn rhs<M: Model<N>, const N: usize>(
    _: f64,
    y: Pointer,
    slope: Pointer,
    data: Pointer,
) -> c_int {
    // SAFETY: `data` is the field of `bdf`, the vectors are its own.
    unsafe {
        let field = &*data.cast::<SmoothField<M, N>>();
        write(slope, field.f(&read(y)));
    }
    0
}

extern "C" fn jacobian<M: Model<N>, const N: usize>(
    _: f64,
    y: Pointer,
    _: Pointer,
    matrix: Pointer,
    data: Pointer,
    _: Pointer,
    _: Pointer,
    _: Pointer,
) -> c_int {
    // SAFETY: as for `rhs`; the matrix is N by N, column by column.
    unsafe {
        let field = &*data.cast::<SmoothField<M, N>>();
        let linear = field.linearise(&read(y));
        let entries = &mut *slice_from_raw_parts_mut(SUNDenseMatrix_Data(matrix), N * N);
        for (row, slopes) in linear.jacobian.iter().enumerate() {
            for (column, slope) in slopes.iter().enumerate() {
                entries[column * N + row] = *slope;
            }
        }
    }
    0
}

/// J s, and ∂f/∂r for the last.
extern "C" fn sensitivity<M: Model<N>, const N: usize>(
    _: c_int,
    _: f64,
    y: Pointer,
    _: Pointer,
    which: c_int,
    along: Pointer,
    slope: Pointer,
    data: Pointer,
    _: Pointer,
    _: Pointer,
) -> c_int {
    // SAFETY: as for `rhs`.
    unsafe {
        let field = &*data.cast::<SmoothField<M, N>>();
        let (linear, along) = (field.linearise(&read(y)), read::<N>(along));
        let dr = f64::from(which as usize == N);
        let mut tangent = linear.design.map(|slope| slope * dr);
        for (slopes, sum) in linear.jacobian.iter().zip(&mut tangent) {
            *sum += slopes.iter().zip(&along).map(|(a, b)| a * b).sum::<f64>();
        }
        write(slope, tangent);
    }
    0
}
