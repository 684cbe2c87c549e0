//! Matrices as they were read, put together.

use super::coefficients::Coefficients;
use super::error::ReduceError;
use super::pencil::Pencil;
use super::place::Place;

/// How far an entry and its mirror image may differ, against the largest entry of the matrix.
const SYMMETRIC: f64 = 1e-9;

impl Pencil {
    /// Puts together what was read.
    ///
    /// # Errors
    /// A matrix is empty or not symmetric, sizes differ, or an unknown has neither stiffness nor mass.
    pub fn new(
        stiffness: &Coefficients,
        mass: &Coefficients,
        damping: Option<&Coefficients>,
    ) -> Result<Self, ReduceError> {
        let all = [Some(stiffness), Some(mass), damping];
        let places = united(all)?;
        let sizes = [
            Some(stiffness.unknowns),
            Some(mass.unknowns),
            damping.map(|one| one.unknowns),
        ];
        let whole = sizes.iter().flatten().max().copied().unwrap_or(0);
        let unknowns = if stiffness.named() {
            places.len()
        } else {
            whole
        };
        let names = ["stiffness", "mass", "damping"];
        let mut triangles = Vec::new();
        for (one, name) in all.into_iter().zip(names) {
            triangles.push(one.map(|one| triangle(one, name, &places)).transpose()?);
        }
        let mut pencil = merged(unknowns, &triangles);
        pencil.places = match stiffness.named() {
            true => places,
            false => (1..=unknowns as u64)
                .map(|node| Place { node, direction: 0 })
                .collect(),
        };
        pencil.check_held()?;
        Ok(pencil)
    }

    /// Every unknown has stiffness or mass.
    fn check_held(&self) -> Result<(), ReduceError> {
        let mut held = vec![false; self.unknowns()];
        for (at, row, column) in self.entries() {
            if self.stiffness[at] != 0.0 || self.mass[at] != 0.0 {
                held[row] = true;
                held[column] = true;
            }
        }
        match held.iter().position(|held| !held) {
            None => Ok(()),
            Some(loose) => Err(ReduceError::Loose {
                place: match self.places[loose] {
                    Place { node, direction: 0 } => format!("row {node}"),
                    place => format!("node {place}"),
                },
            }),
        }
    }
}

/// The places of all matrices in ascending order, where they are named by the matrices themselves, or those of the rows.
fn united(all: [Option<&Coefficients>; 3]) -> Result<Vec<Place>, ReduceError> {
    let [Some(stiffness), others @ ..] = all else {
        return Ok(Vec::new());
    };
    for (one, matrix) in others.into_iter().zip(["mass", "damping"]) {
        let Some(one) = one else { continue };
        if one.scattered != stiffness.scattered || (!one.scattered && differ(one, stiffness)) {
            return Err(ReduceError::Mixed { matrix });
        }
        if !one.scattered && one.unknowns != stiffness.unknowns {
            return Err(ReduceError::Sizes {
                stiffness: stiffness.unknowns,
                matrix,
                unknowns: one.unknowns,
            });
        }
    }
    if !stiffness.scattered {
        return Ok(stiffness.places.clone());
    }
    let mut places: Vec<Place> = all
        .into_iter()
        .flatten()
        .flat_map(|one| one.places.iter().copied())
        .collect();
    places.sort_unstable();
    places.dedup();
    Ok(places)
}

/// Whether both name their rows, and not alike.
fn differ(one: &Coefficients, other: &Coefficients) -> bool {
    let sized = one.places.len() == other.places.len();
    one.named() && other.named() && sized && one.places != other.places
}

/// Entries of a lower triangle: column, row, value, in order.
type Triangle = Vec<(usize, usize, f64)>;

/// The lower triangle of what was read, its unknowns numbered as in `places`.
fn triangle(
    one: &Coefficients,
    matrix: &'static str,
    places: &[Place],
) -> Result<Triangle, ReduceError> {
    let number = |local: usize| match one.scattered {
        true => places.binary_search(&one.places[local]).unwrap_or(local),
        false => local,
    };
    let largest = one
        .entries
        .iter()
        .fold(0.0_f64, |most, entry| most.max(entry.2.abs()));
    if largest == 0.0 {
        let file = one.source.file.clone();
        return Err(ReduceError::Empty { matrix, file });
    }
    let mut all: Vec<(usize, usize, f64, bool)> = (one.entries.iter())
        .map(|&(row, column, value)| {
            let (row, column) = (number(row as usize), number(column as usize));
            (row.min(column), row.max(column), value, row < column)
        })
        .collect();
    all.sort_unstable_by_key(|&(column, row, _, upper)| (column, row, upper));
    let mut lower = Triangle::new();
    let mut rest = all.iter().peekable();
    while let Some(&(column, row, value, upper)) = rest.next() {
        let mirror = rest.next_if(|next| (next.0, next.1) == (column, row) && next.3 != upper);
        let missing = row != column && one.whole;
        let mirrored = mirror.map_or(if missing { 0.0 } else { value }, |next| next.2);
        if (value - mirrored).abs() > SYMMETRIC * largest {
            let name = |at: usize| {
                places
                    .get(at)
                    .map_or((at + 1).to_string(), Place::to_string)
            };
            let (row, column) = if upper { (column, row) } else { (row, column) };
            let (row, column) = (name(row), name(column));
            return Err(ReduceError::Asymmetric {
                matrix,
                row,
                column,
                value,
                mirrored,
            });
        }
        if rest
            .peek()
            .is_some_and(|next| (next.0, next.1) == (column, row))
        {
            let name = |at: usize| {
                places
                    .get(at)
                    .map_or((at + 1).to_string(), Place::to_string)
            };
            let (row, column) = (name(row), name(column));
            return Err(ReduceError::Repeated {
                matrix,
                row,
                column,
            });
        }
        lower.push((column, row, (value + mirrored) / 2.0));
    }
    Ok(lower)
}

/// The triangles on one pattern, with a diagonal throughout.
fn merged(unknowns: usize, triangles: &[Option<Triangle>]) -> Pencil {
    let mut pattern: Vec<(usize, usize)> = (0..unknowns).map(|i| (i, i)).collect();
    for one in triangles.iter().flatten() {
        pattern.extend(one.iter().map(|&(column, row, _)| (column, row)));
    }
    pattern.sort_unstable();
    pattern.dedup();
    let values = |one: &Triangle| {
        let mut values = vec![0.0; pattern.len()];
        let mut at = 0;
        for &(column, row, value) in one {
            while pattern[at] != (column, row) {
                at += 1;
            }
            values[at] += value;
        }
        values
    };
    let mut columns = vec![0; unknowns + 1];
    for (column, _) in &pattern {
        columns[column + 1] += 1;
    }
    for i in 1..columns.len() {
        columns[i] += columns[i - 1];
    }
    let mut values = triangles.iter().map(|one| one.as_ref().map(values));
    let mut next = || values.next().flatten();
    Pencil {
        places: Vec::new(),
        columns,
        stiffness: next().unwrap_or_default(),
        mass: next().unwrap_or_default(),
        damping: next(),
        rows: pattern.iter().map(|&(_, row)| row).collect(),
    }
}
