//! Stiffness, mass and damping on one pattern.

use nalgebra::{DMatrix, DMatrixView};

use super::error::ReduceError;
use super::place::{Place, Point};

/// The lower triangles of stiffness, mass and damping, column by column, on the pattern that holds all of them.
#[derive(Debug, Clone)]
pub struct Pencil {
    pub(super) places: Vec<Place>,
    pub(super) columns: Vec<usize>,
    pub(super) rows: Vec<usize>,
    pub(super) stiffness: Vec<f64>,
    pub(super) mass: Vec<f64>,
    pub(super) damping: Option<Vec<f64>>,
}

impl Pencil {
    /// The number of unknowns.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.columns.len() - 1
    }

    /// Every entry of the pattern: its position, row and column.
    pub(super) fn entries(&self) -> impl Iterator<Item = (usize, usize, usize)> {
        let columns = self.columns.windows(2).enumerate();
        columns.flat_map(move |(column, ends)| {
            (ends[0]..ends[1]).map(move |at| (at, self.rows[at], column))
        })
    }

    /// A matrix on the pattern times vectors.
    pub(super) fn times(&self, values: &[f64], x: DMatrixView<'_, f64>) -> DMatrix<f64> {
        let mut product = DMatrix::zeros(x.nrows(), x.ncols());
        for k in 0..x.ncols() {
            let x = x.column(k);
            let mut y = product.column_mut(k);
            for column in 0..self.unknowns() {
                let mut sum = 0.0;
                for at in self.columns[column]..self.columns[column + 1] {
                    let row = self.rows[at];
                    sum += values[at] * x[row];
                    if row != column {
                        y[row] += values[at] * x[column];
                    }
                }
                y[column] += sum;
            }
        }
        product
    }

    /// `|x|ᵀ |K| |x|` of each column: rounding is that times the machine's precision.
    pub(super) fn magnitudes(&self, x: &DMatrix<f64>) -> Vec<f64> {
        let absolute: Vec<f64> = self.stiffness.iter().map(|value| value.abs()).collect();
        let x = x.abs();
        let product = self.times(&absolute, x.as_view());
        (0..x.ncols())
            .map(|k| x.column(k).dot(&product.column(k)))
            .collect()
    }

    /// The unknowns of named points.
    ///
    /// # Errors
    /// There is no such place, or two points lie at one.
    pub(super) fn at(&self, points: &[Point]) -> Result<Vec<usize>, ReduceError> {
        for (i, one) in points.iter().enumerate() {
            if let Some(other) = points[..i].iter().find(|other| other.place == one.place) {
                return Err(ReduceError::Twice {
                    first: other.name.clone(),
                    second: one.name.clone(),
                    place: one.place.to_string(),
                });
            }
        }
        points.iter().map(|point| self.find(point)).collect()
    }

    fn find(&self, point: &Point) -> Result<usize, ReduceError> {
        let found = self.places.iter().position(|place| *place == point.place);
        found.ok_or_else(|| ReduceError::NoPlace {
            name: point.name.clone(),
            place: point.place.to_string(),
            known: self.known(point.place.node),
        })
    }

    /// What there is instead of a place that there is not.
    fn known(&self, node: u64) -> String {
        let here = self.places.iter().filter(|place| place.node == node);
        let here: Vec<String> = here.map(Place::to_string).collect();
        let named = self.places.iter().any(|place| place.direction > 0);
        match (here.as_slice(), named) {
            ([], true) => {
                let nodes = self.places.iter().map(|place| place.node);
                let (least, most) = nodes.fold((u64::MAX, 0), |(l, m), n| (l.min(n), m.max(n)));
                format!("the nodes that are free to move have numbers from {least} to {most}")
            }
            (_, false) => format!(
                "its matrices name no nodes, so that a place is a row from 1 to {}; `--dofs FILE` names them",
                self.unknowns()
            ),
            (here, _) => format!("node {node} moves in {}", here.join(", ")),
        }
    }

    /// The pencil of the unknowns that are not `fixed`, which are in ascending order; and their numbers.
    pub(super) fn without(&self, fixed: &[usize]) -> (Self, Vec<usize>) {
        let free: Vec<usize> = (0..self.unknowns())
            .filter(|one| !fixed.contains(one))
            .collect();
        let mut number = vec![usize::MAX; self.unknowns()];
        for (new, &old) in free.iter().enumerate() {
            number[old] = new;
        }
        let kept = self.entries();
        let kept = kept
            .filter(|&(_, row, column)| number[row] != usize::MAX && number[column] != usize::MAX);
        let kept: Vec<_> = kept.collect();
        let mut columns = vec![0; free.len() + 1];
        for &(.., column) in &kept {
            columns[number[column] + 1] += 1;
        }
        for i in 1..columns.len() {
            columns[i] += columns[i - 1];
        }
        let pick = |values: &[f64]| kept.iter().map(|&(at, ..)| values[at]).collect();
        let pencil = Self {
            places: free.iter().map(|&old| self.places[old]).collect(),
            columns,
            rows: kept.iter().map(|&(_, row, _)| number[row]).collect(),
            stiffness: pick(&self.stiffness),
            mass: pick(&self.mass),
            damping: None,
        };
        (pencil, free)
    }
}
