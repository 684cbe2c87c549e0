//! What lies beyond a point at which a branch is not smooth.

use super::ZeroProblem;
use super::branch::Started;
use super::located::Located;

/// A point to which a branch comes and beyond which its equations are others.
pub struct Crossing<Q: ZeroProblem, P> {
    /// The point.
    pub located: Located<P>,
    /// What lies beyond.
    pub beyond: Beyond<Q>,
}

/// What continues a branch.
pub enum Beyond<Q: ZeroProblem> {
    /// Nothing does, as is known of such points.
    Nothing,
    /// This does.
    Onwards(Box<Started<Q>>),
    /// Something should, and was not found.
    Undecided,
}
