//! What is left of a structure, and the text in which it is kept.

use std::fmt::{self, Write};
use std::str::FromStr;

use nalgebra::DMatrix;

use super::coefficients::Source;
use super::error::ReduceError;
use super::method::Method;
use super::pencil::Pencil;
use super::place::Point;
use super::projection::{Reduced, projected};

/// A reduced structure: modes of modal mass 1, by their frequencies, damping ratios and shapes at the points.
#[derive(Debug, Clone, PartialEq)]
pub struct Structure {
    /// The method.
    pub method: Method,
    /// The units of the numbers, if they are known: then they are those of the SI.
    pub scale: Option<Scale>,
    /// The unknowns that there were.
    pub unknowns: usize,
    /// The files that it was made of.
    pub sources: Vec<(&'static str, Source)>,
    /// The named points.
    pub points: Vec<Point>,
    /// The modes, of ascending frequency but for those of residual flexibility, which come last.
    pub modes: Vec<Mode>,
    /// Displacements of the points under unit loads at the points that the modes leave out.
    pub residual: DMatrix<f64>,
    /// The largest damping between two modes, against the square root of the product of their own; it is left out.
    pub coupling: f64,
}

/// A mode of modal mass 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// The angular frequency of the undamped mode; 0 where the structure moves as a whole.
    pub frequency: f64,
    /// The damping ratio.
    pub damping: f64,
    /// Its displacement at each point.
    pub shape: Vec<f64>,
}

/// The units in which a structure was given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Metres in the unit of length.
    pub length: f64,
    /// Kilograms in the unit of mass.
    pub mass: f64,
    /// Seconds in the unit of time.
    pub time: f64,
}

impl FromStr for Scale {
    type Err = String;

    /// `m-kg-s`, `mm-t-s` or `mm-kg-ms`: length, mass and time.
    fn from_str(word: &str) -> Result<Self, String> {
        let parts: Vec<&str> = word.split('-').collect();
        let [length, mass, time] = parts[..] else {
            return Err(format!(
                "`{word}` names no three units: write for instance `mm-t-s`"
            ));
        };
        let unit = |what: &str, word: &str, known: &[(&str, f64)]| {
            let found = known.iter().find(|(name, _)| *name == word);
            found.map(|(_, factor)| *factor).ok_or_else(|| {
                let names: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
                format!(
                    "`{word}` is no unit of {what} that is known: there are {}",
                    names.join(", ")
                )
            })
        };
        Ok(Self {
            length: unit(
                "length",
                length,
                &[("m", 1.0), ("cm", 0.01), ("mm", 1e-3), ("in", 0.0254)],
            )?,
            mass: unit("mass", mass, &[("kg", 1.0), ("t", 1e3), ("g", 1e-3)])?,
            time: unit("time", time, &[("s", 1.0), ("ms", 1e-3)])?,
        })
    }
}

/// What stands for no damping at all between two modes.
const UNCOUPLED: f64 = 1e-12;

/// Projects the damping, and keeps what there is at the points.
pub(super) fn damped(
    pencil: &Pencil,
    points: &[Point],
    at: &[usize],
    method: Method,
    reduced: Reduced,
) -> Result<Structure, ReduceError> {
    let count = reduced.values.len();
    let rates = match &pencil.damping {
        Some(damping) => projected(pencil, damping, &reduced.shapes),
        None => DMatrix::zeros(count, count),
    };
    let most = rates.amax();
    let driven = (0..count)
        .filter(|&k| rates[(k, k)] < -UNCOUPLED * most)
        .count();
    if driven > 0 {
        return Err(ReduceError::Indefinite {
            matrix: "damping",
            negative: driven,
        });
    }
    let mut modes = Vec::new();
    for (k, &value) in reduced.values.iter().enumerate() {
        let frequency = value.sqrt();
        if !(frequency.is_finite() && frequency < 1e100) {
            return Err(ReduceError::OutOfReach(frequency));
        }
        let damping = match frequency {
            0.0 if rates[(k, k)].abs() > UNCOUPLED * most => return Err(ReduceError::DampedRigid),
            0.0 => 0.0,
            _ => rates[(k, k)].max(0.0) / (2.0 * frequency),
        };
        let shape: Vec<f64> = at
            .iter()
            .map(|&unknown| reduced.shapes[(unknown, k)])
            .collect();
        modes.push(Mode {
            frequency,
            damping,
            shape: upright(shape),
        });
    }
    Ok(Structure {
        method,
        scale: None,
        unknowns: pencil.unknowns(),
        sources: Vec::new(),
        points: points.to_vec(),
        modes,
        residual: reduced.residual,
        coupling: coupling(&rates),
    })
}

/// The sign for which the largest displacement is positive.
fn upright(mut shape: Vec<f64>) -> Vec<f64> {
    let largest = shape.iter().copied().fold(0.0_f64, |most, one| {
        // Of two alike, the first: rounding shall not choose.
        if one.abs() > most.abs() * (1.0 + 1e-6) {
            one
        } else {
            most
        }
    });
    if largest < 0.0 {
        shape.iter_mut().for_each(|one| *one = -*one);
    }
    shape
}

fn coupling(rates: &DMatrix<f64>) -> f64 {
    let mut most = 0.0_f64;
    for i in 0..rates.nrows() {
        for k in 0..i {
            let own = (rates[(i, i)] * rates[(k, k)]).max(0.0).sqrt();
            if rates[(i, k)] != 0.0 && own > 0.0 {
                most = most.max(rates[(i, k)].abs() / own);
            }
        }
    }
    most
}

impl Structure {
    /// The same structure in units of the SI.
    #[must_use]
    pub fn in_si(mut self, scale: Scale) -> Self {
        let turns: Vec<f64> = (self.points.iter())
            .map(|point| {
                if point.place.turns() {
                    scale.length
                } else {
                    1.0
                }
            })
            .collect();
        for mode in &mut self.modes {
            mode.frequency /= scale.time;
            for (one, turn) in mode.shape.iter_mut().zip(&turns) {
                *one /= scale.mass.sqrt() * turn;
            }
        }
        for (i, row) in turns.iter().enumerate() {
            for (k, column) in turns.iter().enumerate() {
                self.residual[(i, k)] *= scale.time.powi(2) / (scale.mass * row * column);
            }
        }
        self.scale = Some(scale);
        self
    }

    /// What points give way under their own unit loads by modes from this one on and by what no mode has.
    #[must_use]
    pub fn flexibility_beyond(&self, kept: usize) -> Vec<f64> {
        let beyond = self
            .modes
            .iter()
            .skip(kept)
            .filter(|mode| mode.frequency > 0.0);
        let mut flexibility: Vec<f64> = self.residual.diagonal().iter().copied().collect();
        for mode in beyond {
            for (sum, shape) in flexibility.iter_mut().zip(&mode.shape) {
                *sum += (shape / mode.frequency).powi(2);
            }
        }
        flexibility
    }
}

/// The text that a `structure` line reads.
impl fmt::Display for Structure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "stickslip structure 1")?;
        writeln!(f, "method {}", self.method)?;
        writeln!(
            f,
            "units {}",
            if self.scale.is_some() { "SI" } else { "none" }
        )?;
        writeln!(f, "unknowns {}", self.unknowns)?;
        for (role, source) in &self.sources {
            let Source {
                file,
                size,
                checksum,
            } = source;
            writeln!(f, "source {role} {size} bytes crc32 {checksum:08x} {file}")?;
        }
        for Point { name, place } in &self.points {
            writeln!(f, "point {name} {place}")?;
        }
        for Mode {
            frequency,
            damping,
            shape,
        } in &self.modes
        {
            writeln!(f, "mode {frequency:e} {damping:e}{}", numbers(shape.iter()))?;
        }
        for row in self.residual.row_iter() {
            writeln!(f, "residual{}", numbers(row.iter()))?;
        }
        Ok(())
    }
}

fn numbers<'a>(values: impl Iterator<Item = &'a f64>) -> String {
    values.fold(String::new(), |mut text, value| {
        let _ = write!(text, " {value:e}");
        text
    })
}
