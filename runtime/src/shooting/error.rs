//! Why no periodic orbit is found.

use crate::continuation::Failure;
use crate::flow::FlowError;
use crate::lyapunov::Lyapunov;
use crate::model::Values;
use crate::motion::Flow;

/// Why no orbit was found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OrbitError {
    /// The motion came to rest.
    #[error(
        "the motion settles on an equilibrium at {state}: there is no periodic orbit to be found from this start"
    )]
    Equilibrium {
        /// The equilibrium.
        state: Values,
    },
    /// The motion is periodic, and so are those beside it.
    #[error(
        "the motion through {state} is periodic, with the period {period:.9}, but so are those beside it: \
         as far as numbers can tell the orbits form a family, and none is singled out"
    )]
    NotIsolated {
        /// Where it begins.
        state: Values,
        /// Its period.
        period: f64,
    },
    /// The motion runs on and nothing else changes.
    #[error(
        "the motion runs on steadily from {state}: nothing else changes, so that any time would be its period"
    )]
    Steady {
        /// Where it is at some time.
        state: Values,
    },
    /// Neither rest nor a periodic motion within bounds.
    #[error(
        "the motion has not settled on a periodic orbit after the time {time:.6e}{}{}",
        because(.last.as_deref()),
        parting(.exponent.as_ref())
    )]
    NotSettled {
        /// Time followed.
        time: f64,
        /// Why the last return was no orbit; nothing if the motion never came back near where it had been.
        last: Option<Box<OrbitError>>,
        /// Where it had come by then.
        reached: Vec<f64>,
        /// How fast motions beside it part from it then, if that was asked and is known.
        exponent: Option<Lyapunov>,
    },
    /// The motion passes by an orbit and does not stay.
    #[error(
        "the periodic orbit beside it, with the period {period:.9}, is {stability}, and the motion does not stay there"
    )]
    Passed {
        /// The period of the orbit.
        period: f64,
        /// Its stability.
        stability: &'static str,
    },
    /// Newton failed.
    #[error("shooting found no orbit: {0}")]
    Newton(Failure<FlowError>),
    /// The motion cannot be followed.
    #[error(transparent)]
    Flow(#[from] FlowError),
}

impl OrbitError {
    /// That the motion through this state, known up to these errors, is one of a family.
    pub(super) fn one_of_many(
        flow: &dyn Flow,
        (state, period): (&[f64], f64),
        errors: Vec<f64>,
    ) -> Self {
        Self::NotIsolated {
            state: flow.values(state).within(errors),
            period,
        }
    }
}

/// How fast motions part, with the standard error.
fn parting(exponent: Option<&Lyapunov>) -> String {
    let known = exponent.and_then(|found| Some((found.exponent?, found)));
    known.map_or_else(String::new, |(rate, found)| {
        format!(
            "; its largest Lyapunov exponent is {rate:.2e} ± {:.1e} over the time {:.3e} from then on",
            found.error, found.time
        )
    })
}

/// The reason for which the last return of a motion was no orbit, or that there was none.
fn because(last: Option<&OrbitError>) -> String {
    last.map_or_else(
        || ": it did not come back near enough to where it had been".to_owned(),
        |error| format!(": where it came back, {error}"),
    )
}
