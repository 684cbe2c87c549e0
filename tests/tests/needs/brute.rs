//! The answer by brute force: with each number of modes, sampled along the motion.

use stickslip::study::{Case, System, Trajectory};

/// Parts into which each step of a sampled motion is divided.
const PARTS: usize = 16;

/// Least and largest value of each displacement and each state that is none of a mode.
pub(crate) fn answer(system: &System, case: &Case) -> Option<Vec<[f64; 2]>> {
    let case = Case {
        accuracy: 1e-8,
        ..case.clone()
    };
    let orbit = system.orbit(&case).ok()?;
    let from = Case {
        start: Some(orbit.state.clone()),
        ..case
    };
    let motion = system.motion(&from, orbit.period).ok()?;
    let info = system.info();
    let mut reaches = Vec::new();
    for structure in info.structures {
        for point in structure.points {
            let place = |name: String| {
                let mut all = info.observables.iter();
                all.position(|one| one.name == name).expect("an observable")
            };
            let name = format!("{}_{}", structure.name, point.name);
            reaches.push(reach(&motion, place(name.clone()), place(name + "_speed")));
        }
    }
    for (j, state) in info.states.iter().enumerate() {
        if !(state.name.contains("_mode_")
            || state.name.contains("_rate_")
            || info.drive == Some(j))
        {
            reaches.push([orbit.min[j], orbit.max[j]]);
        }
    }
    Some(reaches)
}

/// How far a displacement reaches: by cubics between the samples.
fn reach(motion: &Trajectory, displacement: usize, speed: usize) -> [f64; 2] {
    let mut reach = [f64::INFINITY, f64::NEG_INFINITY];
    for i in 1..motion.times.len() {
        let time = motion.times[i] - motion.times[i - 1];
        let [a, b] = [i - 1, i].map(|i| motion.observables[i][displacement]);
        let [from, to] = [i - 1, i].map(|i| motion.observables[i][speed] * time);
        for part in 0..=PARTS {
            let s = part as f64 / PARTS as f64;
            let value = (1.0 - s).powi(2) * (a * (1.0 + 2.0 * s) + from * s)
                + s * s * (b * (3.0 - 2.0 * s) - to * (1.0 - s));
            reach = [reach[0].min(value), reach[1].max(value)];
        }
    }
    reach
}

/// The error of the answer with only the first modes of its structure, for each number of them up to all.
pub(crate) fn errors(system: &System, case: &Case) -> Vec<f64> {
    let structure = &system.info().structures[0];
    let truth = answer(system, case).expect("an orbit");
    let sizes: Vec<f64> = truth.iter().map(|[a, b]| a.abs().max(b.abs())).collect();
    let error = |kept: usize| {
        let mut thin = case.clone();
        for mode in &structure.modes[kept..structure.kept] {
            thin.parameters[mode.share.expect("an elastic mode")] = 0.0;
        }
        // A structure without an orbit does not answer.
        let Some(found) = answer(system, &thin) else {
            return f64::INFINITY;
        };
        let pairs = truth.iter().zip(&found).zip(&sizes);
        let errors =
            pairs.map(|((a, b), size)| (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) / size);
        errors.fold(0.0, f64::max)
    };
    (1..=structure.kept).map(error).collect()
}

/// The fewest modes with which, and with any more than which, errors stay below this.
pub(crate) fn needed(errors: &[f64], accuracy: f64) -> usize {
    let misses = errors.iter().rposition(|error| *error > accuracy);
    misses.map_or(1, |last| last + 2)
}
