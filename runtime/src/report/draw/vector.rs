//! Vectors in the plane of a drawing.

pub(super) type Vector = [f64; 2];

pub(super) fn difference(to: Vector, from: Vector) -> Vector {
    [to[0] - from[0], to[1] - from[1]]
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The angle between two unit vectors.
pub(super) fn angle(a: Vector, b: Vector) -> f64 {
    (a[0] * b[1] - a[1] * b[0]).atan2(dot(a, b)).abs()
}

pub(super) fn length(vector: Vector) -> f64 {
    vector[0].hypot(vector[1])
}

pub(super) fn unit(vector: Vector) -> Vector {
    let length = length(vector);
    vector.map(|part| part / length)
}
