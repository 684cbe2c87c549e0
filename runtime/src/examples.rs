//! Small models for the unit tests of this crate, written out by hand.

use num_dual::DualSVec64;

use crate::friction::{ContactRule, FrictionLaw, LawInfo};
use crate::model::{Contact, Model, ModelInfo, Parameter, State};
use crate::scalar::Scalar;

/// stick = peak, slip(s) = limit/(1 + decay s).
pub(crate) struct Weakening<D> {
    pub(crate) peak: D,
    pub(crate) limit: D,
    pub(crate) decay: D,
}

impl<D: Scalar> FrictionLaw<D> for Weakening<D> {
    const INFO: &'static LawInfo = &LAW;

    fn stick(&self) -> D {
        self.peak
    }

    fn slip(&self, speed: D) -> D {
        self.limit / (self.decay * speed + 1.0)
    }
}

const LAW: LawInfo = LawInfo {
    name: "Weakening",
    doc: "",
    parameters: &[],
    stick: "peak",
    slip: "limit / (1.0 + decay * s)",
};

const fn state(start: f64) -> State {
    State {
        name: "",
        doc: "",
        unit: None,
        start,
        equation: "",
    }
}

const CONTACT: Contact = Contact {
    name: "F",
    doc: "",
    unit: None,
    law: &LAW,
    fields: "",
    speed: "",
};

macro_rules! by_hand {
    ($(#[doc = $doc:literal])* $name:ident, $n:literal states, $lanes:literal lanes, $p:literal parameters,
     $c:literal contacts, $defaults:expr, |$params:ident, $y:ident, $contacts:ident| $body:block) => {
        $(#[doc = $doc])*
        #[derive(Debug, Clone, Copy)]
        pub(crate) struct $name(pub(crate) [f64; $p]);

        impl Default for $name {
            fn default() -> Self {
                Self($defaults)
            }
        }

        impl Model<$n> for $name {
            type Params<D: Scalar> = [D; $p];
            type PerContact<T: Copy + Send + Sync> = [T; $c];
            type Observables = [f64; 0];
            type Lanes = DualSVec64<$lanes>;

            const INFO: &'static ModelInfo = &ModelInfo {
                name: stringify!($name),
                command: stringify!($name),
                doc: "",
                states: &[const { state(0.0) }; $n],
                parameters: &[] as &[Parameter],
                observables: &[],
                contacts: &[CONTACT; $c],
            };
            const KINEMATIC: [Option<usize>; $n] = [None; $n];
            const SPARSITY: [[bool; $n]; $n] = [[true; $n]; $n];

            fn values(&self) -> [f64; $p] {
                self.0
            }

            fn from_values(values: [f64; $p]) -> Self {
                Self(values)
            }

            fn rhs<D: Scalar>(
                $params: &[D; $p],
                $y: [D; $n],
                $contacts: &mut impl ContactRule<D>,
            ) -> [D; $n] $body

            fn observables(
                _: &[f64; $p],
                _: [f64; $n],
                _: &mut impl ContactRule<f64>,
            ) -> [f64; 0] {
                []
            }
        }
    };
}

by_hand! {
    /// One mass on a belt: m, k, v_dr, limit, decay, peak.
    Belt, 2 states, 3 lanes, 6 parameters, 1 contacts, [1.0, 1.0, 0.2, 1.0, 3.0, 1.0],
    |p, y, contacts| {
        let [m, k, belt, limit, decay, peak] = *p;
        let [x, v] = y;
        let force = contacts.force(0, &Weakening { peak, limit, decay }, v - belt);
        [v, (force - k * x) / m]
    }
}

by_hand! {
    /// Two masses on a belt: α, β, γ, v_dr, peak over limit.
    Pair, 4 states, 5 lanes, 5 parameters, 2 contacts, [1.2, 1.3, 3.0, 0.14, 1.0],
    |p, y, contacts| {
        let [alpha, beta, decay, belt, peak] = *p;
        let [x1, v1, x2, v2] = y;
        let one = D::from(1.0);
        let first = contacts.force(0, &Weakening { peak, limit: one, decay }, v1 - belt);
        let second = contacts.force(1, &Weakening { peak: peak * beta, limit: beta, decay }, v2 - belt);
        let coupling = alpha * (x1 - x2);
        [v1, first - x1 - coupling, v2, second - x2 + coupling]
    }
}

by_hand! {
    /// A sledge on a belt that carries another: the upper contact rubs between them, G is full, the lower
    /// mass grows with its place, the upper spring hardens. v_dr, upper mass, peak over limit, growth.
    Sledges, 4 states, 5 lanes, 4 parameters, 2 contacts, [0.3, 0.7, 1.2, 0.2],
    |p, y, contacts| {
        let [belt, upper, peak, growth] = *p;
        let [x1, v1, x2, v2] = y;
        let (one, half, decay) = (D::from(1.0), D::from(0.5), D::from(2.0));
        let lower = growth * x1 * x1 + 1.0;
        let ground = contacts.force(0, &Weakening { peak, limit: one, decay }, v1 - belt);
        let between = contacts.force(1, &Weakening { peak: peak * half, limit: half, decay }, v2 - v1);
        let pull = -x2 - x2 * x2 * x2 * 0.3;
        [v1, (ground - between - x1) / lower, v2, (between + pull) / upper]
    }
}

by_hand! {
    /// A bead in a groove whose floor moves with the square of the place: w is not affine. v_dr, peak, curvature.
    Groove, 2 states, 3 lanes, 3 parameters, 1 contacts, [0.3, 1.1, 0.2],
    |p, y, contacts| {
        let [belt, peak, curvature] = *p;
        let [x, v] = y;
        let (limit, decay) = (D::from(1.0), D::from(2.0));
        let speed = v - belt * (curvature * x * x + 1.0);
        let force = contacts.force(0, &Weakening { peak, limit, decay }, speed);
        [v, force - x]
    }
}

by_hand! {
    /// A force whose sign is wrong: it pushes the way the contact slides.
    Wrong, 2 states, 3 lanes, 1 parameters, 1 contacts, [1.0],
    |p, y, contacts| {
        let [limit] = *p;
        let law = Weakening { peak: limit, limit, decay: D::from(0.0) };
        let force = contacts.force(0, &law, y[1]);
        [y[1], -force - y[0]]
    }
}

by_hand! {
    /// Two friction elements in parallel: their forces at rest are not unique.
    Parallel, 2 states, 3 lanes, 1 parameters, 2 contacts, [1.0],
    |p, y, contacts| {
        let [limit] = *p;
        let law = Weakening { peak: limit, limit, decay: D::from(0.0) };
        let force = contacts.force(0, &law, y[1]) + contacts.force(1, &law, y[1]);
        [y[1], force - y[0]]
    }
}
