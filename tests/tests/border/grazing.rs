//! Where an orbit only just comes to stick, and its branch turns: nothing is told beyond, and nothing of the way there again.

use stickslip::bifurcation::Kind;
use stickslip::study::BranchRecord;
use stickslip::{friction_law, model};
use stickslip_models::friction::Tustin;
use stickslip_tests::branches::{branch, named};

friction_law! {
    /// A rope around a drum: its tight end holds exp(μφ) times what its slack one does, and μ falls with the speed.
    struct Wound {
        param held where held > 0.0;
        param sliding where sliding > 0.0;
        param speed where speed > 0.0;
        stick = exp(held) - 1.0;
        slip(s) = exp(sliding + (held - sliding) * exp(-s / speed)) - 1.0;
    }
}

model! {
    /// A mass on a rope that is wound once around a turning drum.
    struct Capstan {
        state x = 0.5;
        state v = 0.0;
        param drum = 0.5;
        friction F = Wound { held: 0.6 * 3.141592653589793, sliding: 0.4 * 3.141592653589793, speed: 0.3 } opposing v - drum;
        der(x) = v;
        der(v) = F - 10.0 * x - 0.2 * v;
    }
}

model! {
    /// A clutch that warms up as it judders, and holds less.
    struct Judder {
        state twist: rad = 0.0;
        state w: rad/s = 0.0;
        state warm = 0.5;
        param engine: rad/s = 10.0;
        param cap: N*m = 50.0 where cap >= 0.0;
        let level = cap * (1.0 - 0.3 * warm);
        friction F: N*m = Tustin { static_level: level, kinetic_level: 0.7 * level, speed: 3.0, viscous: 0.0 } opposing w - engine;
        der(twist) = w;
        der(w) = (F - 40.0 * twist - 0.05 * w) / 0.1;
        der(warm) = (0.2 - warm - 0.002 * F * (w - engine)) / 20.0;
    }
}

/// The one grazing point of a branch, r and error, and the largest r at which one of its orbits sticks.
fn grazing(branch: &BranchRecord) -> ([f64; 2], f64) {
    let grazes = |kind: &Kind| *kind == Kind::GrazingSliding;
    let all: Vec<_> = branch
        .special
        .iter()
        .filter(|one| grazes(&one.kind))
        .collect();
    assert_eq!(all.len(), 1, "{:?}", named(branch));
    let sticks = |word: &String| word.contains("stick");
    let rows = branch.points.iter();
    let stuck = rows.filter(|row| row.word.as_ref().is_some_and(sticks));
    let last = stuck.filter_map(|row| row.r).fold(f64::MIN, f64::max);
    ([all[0].r, all[0].error.expect("an error")], last)
}

/// Beyond, the mass misses the speed of the drum, and Newton's method swings between an orbit that would stick and one that
/// would not: as much as its accuracy allows, that went for an orbit, over and over again.
#[test]
fn no_orbit_sticks_beyond_the_turn_at_which_it_grazes() {
    // By halving on integrations of the sliding motion from where it lets go (DOP853 of SciPy, rtol 1e-12).
    let known = 3.26997762364730;
    for accuracy in [1e-4, 1e-5, 1e-6, 1e-8] {
        let found = branch(&[], Capstan::drum, (0.1, 4.0), |case| {
            case.accuracy = accuracy
        });
        assert_eq!(found.ended.word(), "hopf", "{}", found.ended.reason);
        assert!(found.points.len() < 100, "{}", found.points.len());
        let ([r, error], last) = grazing(&found);
        assert!((r - known).abs() <= error, "{accuracy:e}: {r} {error:e}");
        // Each is known to the accuracy, and so is whether it sticks.
        assert!(
            last <= known * (1.0 + 3.0 * accuracy),
            "{accuracy:e}: {last}"
        );
    }
}

/// Beside the turn, orbits that stick and such that do not are nearer to each other than Newton's method can tell, and what is
/// warm holds on to errors.
#[test]
fn a_branch_that_turns_where_it_grazes_does_not_walk_back() {
    for accuracy in [1e-5, 1e-6, 1e-8] {
        let found = branch(&[], Judder::engine, (30.0, 40.0), |case| {
            case.accuracy = accuracy
        });
        assert_eq!(
            found.ended.word(),
            "reached-start",
            "{}",
            found.ended.reason
        );
        let ([r, error], last) = grazing(&found);
        // The same branch at the accuracy 1e-10.
        assert!(
            (r - 35.8730073961).abs() <= error,
            "{accuracy:e}: {r} {error:e}"
        );
        assert!(last <= r + error, "{accuracy:e}: {last}");
        let word = found.points.last().and_then(|row| row.word.clone());
        assert_eq!(word.as_deref(), Some("slip-(F)"));
    }
}
