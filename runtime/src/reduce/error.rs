//! Why a structure cannot be reduced.

use thiserror::Error;

/// Why a structure cannot be read or reduced.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ReduceError {
    /// A file that cannot be opened.
    #[error("`{file}` cannot be read: {reason}")]
    Unreadable {
        /// Its name.
        file: String,
        /// What the system says.
        reason: String,
    },
    /// A file in none of the formats that are read.
    #[error(
        "`{file}` is in no format that is read: Matrix Market begins with `%%MatrixMarket`, a Nastran punch file has \
         `DMIG` lines, and CalculiX's `.sti` and `.mas` have three columns: row, column, value"
    )]
    Unknown {
        /// Its name.
        file: String,
    },
    /// A line that makes no sense.
    #[error("`{file}`, line {line}: {reason}")]
    Malformed {
        /// The name of the file.
        file: String,
        /// The number of the line, from 1.
        line: usize,
        /// What is wrong with it.
        reason: String,
    },
    /// A matrix without a number other than zero.
    #[error("the {matrix} in `{file}` is empty: it has no entry other than zero")]
    Empty {
        /// `stiffness`, `mass` or `damping`.
        matrix: &'static str,
        /// The name of the file.
        file: String,
    },
    /// An entry and its mirror image differ.
    #[error(
        "the {matrix} is not symmetric: row {row}, column {column} holds {value:e}, and row {column}, column {row} holds \
         {mirrored:e}; contacts and gyroscopic terms belong into the model, not into the matrices"
    )]
    Asymmetric {
        /// `stiffness`, `mass` or `damping`.
        matrix: &'static str,
        /// Its row, a number or a place.
        row: String,
        /// Its column.
        column: String,
        /// The entry.
        value: f64,
        /// Its mirror image.
        mirrored: f64,
    },
    /// An entry that is there twice.
    #[error(
        "the {matrix} has the entry of row {row}, column {column} twice: keep one, or add them up"
    )]
    Repeated {
        /// `stiffness`, `mass` or `damping`.
        matrix: &'static str,
        /// Its row, a number or a place.
        row: String,
        /// Its column.
        column: String,
    },
    /// Matrices whose rows are not named alike.
    #[error(
        "the rows of the {matrix} are not named as those of the stiffness: give both in one format, from one run"
    )]
    Mixed {
        /// `mass` or `damping`.
        matrix: &'static str,
    },
    /// Matrices of different sizes.
    #[error(
        "the stiffness has {stiffness} unknowns, but the {matrix} has {unknowns}: both must be of the same structure, \
         with the same unknowns held fixed"
    )]
    Sizes {
        /// The unknowns of the stiffness.
        stiffness: usize,
        /// `mass` or `damping`.
        matrix: &'static str,
        /// Its unknowns.
        unknowns: usize,
    },
    /// An unknown on which nothing acts.
    #[error(
        "{place} has neither stiffness nor mass: leave it out of the matrices, or hold it fixed"
    )]
    Loose {
        /// Where.
        place: String,
    },
    /// Stiffness and mass vanish for the same motion.
    #[error(
        "there is a motion with neither stiffness nor mass: the matrices are singular together (the factorisation \
         breaks off at unknown {unknown})"
    )]
    Singular {
        /// The number of the unknown, from 1, in the order of elimination.
        unknown: usize,
    },
    /// A matrix with negative eigenvalues.
    #[error(
        "the {matrix} is indefinite: {negative} of its eigenvalues {verb} negative, so that the structure would buckle or \
         gain energy; check the units and the sign, and whether the matrix is complete",
        verb = if *negative == 1 { "is" } else { "are" }
    )]
    Indefinite {
        /// `stiffness`, `mass` or `damping`.
        matrix: &'static str,
        /// How many.
        negative: usize,
    },
    /// The factors do not fit.
    #[error("the factors of the matrices need more memory than there is")]
    Memory,
    /// A place that the structure does not have.
    #[error("`{name}={place}`: the structure has no such place; {known}")]
    NoPlace {
        /// The name of the point.
        name: String,
        /// The place as it is written.
        place: String,
        /// What there is instead.
        known: String,
    },
    /// A name or a place that is given to two points.
    #[error("the points `{first}` and `{second}` lie both at {place}: keep one of them")]
    Twice {
        /// One name.
        first: String,
        /// The other.
        second: String,
        /// The place.
        place: String,
    },
    /// Fixing all points leaves the structure loose.
    #[error(
        "with its points held fixed the structure can still move as a whole, which Craig and Bampton's method does not \
         allow: choose `--method free`, or name more points"
    )]
    StillLoose,
    /// More modes are asked for than there are.
    #[error("{wanted} modes are asked for, but the structure has only {there}")]
    TooMany {
        /// The modes that are asked for.
        wanted: usize,
        /// The modes with a finite frequency.
        there: usize,
    },
    /// The eigenvalues did not converge.
    #[error(
        "the modes did not converge: {converged} of {wanted} did in a space of {dimension} vectors"
    )]
    NotConverged {
        /// Those that did.
        converged: usize,
        /// Those that were sought.
        wanted: usize,
        /// The dimension of the Krylov space.
        dimension: usize,
    },
    /// Sylvester's law of inertia counts other modes than were found.
    #[error(
        "{found} modes were found below {frequency:e} rad per unit of time, but there are {there}: the matrices are too \
         ill-conditioned"
    )]
    Missed {
        /// The modes that were found.
        found: usize,
        /// The modes that there are.
        there: usize,
        /// Below which angular frequency.
        frequency: f64,
    },
    /// Viscous forces on a motion as a whole cannot be said by a damping ratio.
    #[error(
        "the damping acts on a motion of the whole structure that no spring opposes: a damping ratio cannot express it; \
         write such forces in the model, at the points"
    )]
    DampedRigid,
    /// Numbers that overflow.
    #[error("the matrices hold magnitudes that cannot be combined: a mode has the frequency {0:e}")]
    OutOfReach(f64),
}
