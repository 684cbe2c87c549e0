//! Ways to go once around a smooth orbit: ours, each method of ours by itself, and a library's.

use std::ops::ControlFlow;

use stickslip::field::Work;
use stickslip::integrate::explicit::{Settings, integrate};
use stickslip::integrate::{Motion, RADAU_3, RADAU_5, Radau, Tableau};
use stickslip::model::Model;

use crate::round::{Round, Sensitivities, both};

/// Steps after which a contender gives up.
const BUDGET: u64 = 200_000;

/// A method with a name; it may fail.
pub(crate) struct Contender<M, const N: usize> {
    pub(crate) name: &'static str,
    pub(crate) run: fn(&Round<M, N>, f64) -> Option<Sensitivities<N>>,
}

/// What the program does: it chooses between the methods by stiffness.
pub(crate) fn ours<M: Model<N>, const N: usize>() -> Contender<M, N> {
    Contender {
        name: "stickslip",
        run: |round, tolerance| {
            let derivatives = round.try_go(tolerance)?.derivatives?;
            Some((derivatives.state, derivatives.design))
        },
    }
}

/// Our methods one by one.
pub(crate) fn methods<M: Model<N>, const N: usize>() -> [Contender<M, N>; 3] {
    [
        Contender {
            name: "Radau IIA, 5 stages",
            run: |round, tolerance| implicit(round, &RADAU_5, tolerance),
        },
        Contender {
            name: "Radau IIA, 3 stages",
            run: |round, tolerance| implicit(round, &RADAU_3, tolerance),
        },
        Contender {
            name: "DOP853",
            run: dop853,
        },
    ]
}

fn implicit<M: Model<N>, const N: usize, const S: usize>(
    round: &Round<M, N>,
    tableau: &'static Tableau<S>,
    tolerance: f64,
) -> Option<Sensitivities<N>> {
    let (field, tolerance) = (round.field(), both(tolerance));
    let mut radau = Radau::new(&field, tableau, tolerance, round.start, 0.0, BUDGET).ok()?;
    let mut motion = Motion::from(round.start);
    while radau.time() < round.period {
        radau.step(round.period).ok()?;
        motion = motion.through(&radau.propagator());
    }
    Some((motion.tangent, motion.design))
}

fn dop853<M: Model<N>, const N: usize>(
    round: &Round<M, N>,
    tolerance: f64,
) -> Option<Sensitivities<N>> {
    let settings = Settings {
        steps: BUDGET,
        stiff_steps: u32::MAX,
        ..Settings::new(both(tolerance))
    };
    let (mut work, from) = (Work::default(), Motion::from(round.start));
    let motion = integrate(
        &round.field(),
        settings,
        from,
        round.period,
        &mut work,
        |_| ControlFlow::Continue(()),
    )
    .ok()?;
    Some((motion.tangent, motion.design))
}

/// What a library offers, if it is compiled in.
#[cfg(feature = "diffsol")]
pub(crate) fn library<M: Model<N>, const N: usize>() -> Vec<Contender<M, N>> {
    vec![Contender {
        name: "diffsol",
        run: crate::rival::bdf,
    }]
}

#[cfg(not(feature = "diffsol"))]
pub(crate) fn library<M: Model<N>, const N: usize>() -> Vec<Contender<M, N>> {
    Vec::new()
}
