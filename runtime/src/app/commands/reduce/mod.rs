//! `reduce`: a structure of many unknowns becomes a few modes.

mod answer;

use std::path::{Path, PathBuf};

use clap::Args;

use crate::app::failure::{Failure, refuse};
use crate::app::offer::App;
use crate::app::print::print;
use crate::app::values::Reading;
use crate::app::words::{both_sides, count, place, positive};
use crate::reduce::{
    Coefficients, Method, Pencil, Place, Point, ReduceError, Scale, Structure, place_rows, read,
    reduce,
};

/// Reduce the matrices of a finite element program to the modes that a model needs
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "Matrices are read from Matrix Market files, from CalculiX's `.sti` and `.mas` (the `.dof` beside them \
                  names the rows) and from Nastran's DMIG punch files, both of which may be one file. The file that is \
                  written is read by the line `structure beam = \"beam.structure\" keeping 12;` of a model"
)]
pub(in crate::app) struct Arguments {
    /// The stiffness, the mass and, if there is one, the damping
    #[arg(value_name = "FILE", num_args = 0..)]
    files: Vec<PathBuf>,
    /// Name a point, a node and its direction: x, y, z or the rotations rx, ry, rz; may be given several times
    #[arg(long, value_name = "NAME=NODE:DIRECTION", value_parser = Reading(point))]
    at: Vec<Point>,
    /// How many of the lowest modes are computed [default: 20]
    #[arg(long, value_name = "COUNT", value_parser = Reading(modes))]
    modes: Option<usize>,
    /// How residual flexibility is kept: free, with its mass, craig-bampton, from modes with the points held, or massless [default: free]
    #[arg(long, value_name = "METHOD", value_parser = Reading(method))]
    method: Option<Method>,
    /// A damping ratio of all modes, where there is no damping matrix
    #[arg(long, value_name = "RATIO", value_parser = Reading(positive))]
    ratio: Option<f64>,
    /// The units of length, mass and time in the matrices, for instance mm-t-s; without them, the model's numbers have none
    #[arg(long, value_name = "UNITS", value_parser = Reading(units))]
    units: Option<Scale>,
    /// The place of each row, as CalculiX writes them, where the matrices do not name it
    #[arg(long, value_name = "FILE")]
    dofs: Option<PathBuf>,
    /// The file that is written
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

const DEFAULT_MODES: usize = 20;

fn point(option: &str, word: &str) -> Result<Point, Failure> {
    let (name, place) = both_sides(option, word)?;
    let plain = name
        .chars()
        .all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
    if !plain || name.starts_with(|first: char| first.is_ascii_digit()) {
        return refuse!(
            "`{option} {word}`: `{name}` is no name that a model can use: it has letters, digits and `_`, and begins with a letter"
        );
    }
    let place: Result<Place, String> = place.parse();
    match place {
        Ok(place) => Ok(Point {
            name: name.to_owned(),
            place,
        }),
        Err(reason) => refuse!("`{option} {word}`: {reason}"),
    }
}

fn modes(option: &str, word: &str) -> Result<usize, Failure> {
    count(option, word, [1, 2000])
}

fn method(option: &str, word: &str) -> Result<Method, Failure> {
    let names = Method::names();
    place(&format!("`{option}` has no method"), word, &names)?;
    word.parse()
        .map_err(|()| Failure::usage(format!("`{option} {word}`: there is no such method")))
}

fn units(option: &str, word: &str) -> Result<Scale, Failure> {
    word.parse()
        .map_err(|reason| Failure::usage(format!("`{option}`: {reason}")))
}

pub(in crate::app) fn perform(_: &App, arguments: &Arguments) -> Result<(), Failure> {
    let [stiffness, mass, damping @ ..] = arguments.files.as_slice() else {
        return refuse!(
            "`reduce` needs the stiffness and the mass: `reduce beam.sti beam.mas --at tip=871:y`"
        );
    };
    check(arguments, damping)?;
    let coefficients = |path: &Path, role| coefficients(path, role, arguments.dofs.as_deref());
    let damping = damping
        .first()
        .map(|path| coefficients(path, "damping"))
        .transpose()?;
    let (stiffness, mass) = (
        coefficients(stiffness, "stiffness")?,
        coefficients(mass, "mass")?,
    );
    let pencil = Pencil::new(&stiffness, &mass, damping.as_ref()).map_err(failed)?;
    let wanted = arguments
        .modes
        .unwrap_or(DEFAULT_MODES.min(pencil.unknowns()));
    let method = arguments.method.unwrap_or_default();
    let mut structure = reduce(&pencil, &arguments.at, wanted, method).map_err(failed)?;
    structure.sources = [
        ("stiffness", Some(stiffness)),
        ("mass", Some(mass)),
        ("damping", damping),
    ]
    .into_iter()
    .filter_map(|(role, one)| Some((role, one?.source)))
    .collect();
    if let Some(scale) = arguments.units {
        structure = structure.in_si(scale);
    }
    if let Some(ratio) = arguments.ratio {
        let elastic = structure
            .modes
            .iter_mut()
            .filter(|mode| mode.frequency > 0.0);
        elastic.for_each(|mode| mode.damping = ratio);
    }
    deliver(&structure, arguments.out.as_deref())
}

/// What the command line says twice.
fn check(arguments: &Arguments, damping: &[PathBuf]) -> Result<(), Failure> {
    if damping.len() > 1 {
        return refuse!(
            "`reduce` takes the stiffness, the mass and one damping: {} files are given",
            arguments.files.len()
        );
    }
    if arguments.ratio.is_some() && !damping.is_empty() {
        return refuse!("`--ratio` and a damping matrix exclude each other: leave one out");
    }
    if arguments.at.is_empty() {
        return refuse!(
            "no point is named: `--at tip=871:y` says where forces act and displacements are wanted"
        );
    }
    for (i, one) in arguments.at.iter().enumerate() {
        if arguments.at[..i].iter().any(|other| other.name == one.name) {
            return refuse!(
                "`--at {}=...` is given more than once: each point has its own name",
                one.name
            );
        }
    }
    Ok(())
}

fn coefficients(
    path: &Path,
    role: &'static str,
    dofs: Option<&Path>,
) -> Result<Coefficients, Failure> {
    let mut read = read(path, role).map_err(failed)?;
    if let Some(dofs) = dofs {
        if read.scattered {
            return refuse!("`--dofs`: `{}` names its rows itself", path.display());
        }
        place_rows(&mut read, dofs).map_err(failed)?;
    }
    Ok(read)
}

fn failed(error: ReduceError) -> Failure {
    match error {
        ReduceError::NoPlace { .. } | ReduceError::Twice { .. } | ReduceError::StillLoose => {
            Failure::usage(error.to_string())
        }
        _ => Failure::failed(error.to_string()),
    }
}

fn deliver(structure: &Structure, out: Option<&Path>) -> Result<(), Failure> {
    if let Some(path) = out {
        std::fs::write(path, structure.to_string()).map_err(|error| {
            Failure::failed(format!("`{}` cannot be written: {error}", path.display()))
        })?;
    }
    print(&answer::describe(structure, out))
}
