//! What a scene needs of its structures, as a figure.

use crate::model::{ModelInfo, Structure, StructurePoint};
use crate::report::{Axis, Curve, Figure, Marker, Panel};
use crate::study::{ModesNeed, ModesPoint, NeedsRecord};

/// Of each structure, the error of the answer against the modes that are kept, and what its modes are at its points.
pub(super) fn picture(info: &ModelInfo, record: &NeedsRecord) -> Figure {
    let figure = Figure::new("", info.name, String::new()).columns(2);
    let pairs = record.modes.iter().zip(info.structures);
    let panels = pairs.flat_map(|(need, structure)| [errors(need, record), shapes(structure)]);
    panels.fold(figure, Figure::panel)
}

fn errors(need: &ModesNeed, record: &NeedsRecord) -> Panel {
    let x = Axis::new(&format!("modes of {} that are kept", need.structure)).counting();
    let along = |value: fn(&ModesPoint) -> Option<f64>| -> Vec<[f64; 2]> {
        let points = need.scan.iter().rev();
        let points = points.filter_map(|point| Some([point.modes as f64, value(point)?]));
        points.filter(|[_, value]| *value > 0.0).collect()
    };
    let ends = [need.scan.last(), need.scan.first()];
    let asked = ends
        .iter()
        .flatten()
        .map(|end| [end.modes as f64, record.accuracy]);
    let curves = [
        marked(
            "error of the answer",
            0,
            Marker::Circle,
            along(|point| point.error),
        ),
        marked(
            "flexibility that is left out",
            1,
            Marker::Square,
            along(|point| Some(point.flexibility)),
        ),
    ];
    Panel::new(x, Axis::new("relative error, share").logarithmic())
        .curve(Curve::line("accuracy asked for", 2, asked.collect()))
        .curves(curves.into_iter().flatten())
}

fn shapes(structure: &Structure) -> Panel {
    let x = Axis::new(&format!("mode of {}", structure.name)).counting();
    let at = |(j, point): (usize, &StructurePoint)| {
        // One legend serves both panels: what the other one shows has symbols of its own.
        let series = ERRORS + j;
        let modes = structure.modes.iter().enumerate();
        let places = modes.map(|(k, mode)| [(k + 1) as f64, mode.shape[j]]);
        let marker = MARKERS[series % MARKERS.len()];
        marked(point.name, series, marker, places.collect())
    };
    let points = structure.points.iter().enumerate();
    Panel::new(x, Axis::new("mass-normalised shape")).curves(points.flat_map(at))
}

/// Series of the panel of errors.
const ERRORS: usize = 3;
const MARKERS: [Marker; 4] = [
    Marker::Circle,
    Marker::Square,
    Marker::Diamond,
    Marker::Triangle,
];

/// Values of whole numbers, with lines between them to be followed by eye.
fn marked(label: &str, series: usize, marker: Marker, points: Vec<[f64; 2]>) -> [Curve; 2] {
    [
        Curve::line("", series, points.clone()),
        Curve::points(label, series, marker, points),
    ]
}
