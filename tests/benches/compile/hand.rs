// One model as `model!` would expand it, written by hand.

use stickslip::DualSVec64;
use stickslip::friction::{ContactRule, FrictionLaw, SlopeRule};
use stickslip::model::{Bound, Bounds, Contact, Model, ModelInfo, ParamId, Parameter, Rates, State, Unit};
use stickslip::scalar::Scalar;
use stickslip_models::friction::Weakening;

/// One mass on a moving belt, held by a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Belt {
    /// Mass.
    pub m: f64,
    /// Spring stiffness.
    pub k: f64,
    /// Velocity of the belt.
    pub v_dr: f64,
    /// Largest static friction force.
    pub F_s: f64,
    /// Rate at which friction weakens with speed.
    pub delta: f64,
}

impl Default for Belt {
    fn default() -> Self {
        Self { m: 1.0, k: 1.0, v_dr: 0.2, F_s: 1.0, delta: 3.0 }
    }
}

#[allow(non_upper_case_globals)]
impl Belt {
    pub const m: ParamId<Self> = ParamId::new(0);
    pub const k: ParamId<Self> = ParamId::new(1);
    pub const v_dr: ParamId<Self> = ParamId::new(2);
    pub const F_s: ParamId<Self> = ParamId::new(3);
    pub const delta: ParamId<Self> = ParamId::new(4);
}

const fn unit(text: &'static str, dimension: [i16; 7]) -> Option<Unit> {
    Some(Unit { text, dimension })
}

const fn above(value: f64, inclusive: bool) -> Bounds {
    Bounds { lower: Some(Bound { value, inclusive }), upper: None }
}

impl Model<2> for Belt {
    type Params<D: Scalar> = [D; 5];
    type PerContact<T: Copy + Send + Sync> = [T; 1];
    type Observables = [f64; 0];
    type Lanes = DualSVec64<3>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "Belt",
        command: "belt",
        doc: "One mass on a moving belt, held by a spring.",
        states: &[
            State { name: "x", doc: "Displacement of the mass.", unit: unit("m", [12, 0, 0, 0, 0, 0, 0]), start: 1.0, equation: "v" },
            State { name: "v", doc: "Velocity of the mass.", unit: unit("m/s", [12, 0, -12, 0, 0, 0, 0]), start: 0.0, equation: "(F - k * x) / m" },
        ],
        parameters: &[
            Parameter { name: "m", doc: "Mass.", unit: unit("kg", [0, 12, 0, 0, 0, 0, 0]), default: 1.0, bounds: above(0.0, false) },
            Parameter { name: "k", doc: "Spring stiffness.", unit: unit("N/m", [0, 12, -24, 0, 0, 0, 0]), default: 1.0, bounds: above(0.0, false) },
            Parameter { name: "v_dr", doc: "Velocity of the belt.", unit: unit("m/s", [12, 0, -12, 0, 0, 0, 0]), default: 0.2, bounds: Bounds::NONE },
            Parameter { name: "F_s", doc: "Largest static friction force.", unit: unit("N", [12, 12, -24, 0, 0, 0, 0]), default: 1.0, bounds: above(0.0, true) },
            Parameter { name: "delta", doc: "Rate at which friction weakens with speed.", unit: unit("s/m", [-12, 0, 12, 0, 0, 0, 0]), default: 3.0, bounds: above(0.0, true) },
        ],
        observables: &[],
        contacts: &[Contact {
            name: "F",
            doc: "",
            unit: unit("N", [12, 12, -24, 0, 0, 0, 0]),
            law: <Weakening<f64> as FrictionLaw<f64>>::INFO,
            fields: "limit: F_s, decay: delta",
            speed: "v - v_dr",
            speed_unit: unit("m/s", [12, 0, -12, 0, 0, 0, 0]),
            states: &[],
            presses: &[],
            moving: &[],
        }],
        memories: &[],
        presses: &[],
        moving: false,
        straight: true,
        structures: &[],
        drive: None,
    };
    const KINEMATIC: [Option<usize>; 2] = [Some(1), None];
    const SPARSITY: [[bool; 2]; 2] = [[false, true], [true, true]];

    fn values(&self) -> [f64; 5] {
        [self.m, self.k, self.v_dr, self.F_s, self.delta]
    }

    fn from_values([m, k, v_dr, F_s, delta]: [f64; 5]) -> Self {
        Self { m, k, v_dr, F_s, delta }
    }

    fn rhs<D: Scalar>(
        &[m, k, v_dr, limit, decay]: &[D; 5],
        [x, v]: [D; 2],
        contacts: &mut impl ContactRule<D>,
    ) -> [D; 2] {
        let force = contacts.force(0, &Weakening { limit, decay }, v - v_dr);
        [v, (force - k * x) / m]
    }

    fn entries(
        &[m, k, v_dr, limit, decay]: &[f64; 5],
        &[dm, dk, dv_dr, dlimit, ddecay]: &[f64; 5],
        [x, v]: [f64; 2],
        contacts: &mut impl SlopeRule,
        mut entry: impl FnMut(usize, usize, f64),
    ) -> Rates<2> {
        let along = Weakening { limit: dlimit, decay: ddecay };
        let slopes = contacts.force(0, &Weakening { limit, decay }, &along, v - v_dr);
        let rate = (slopes.force - k * x) / m;
        let by_design = slopes.along + slopes.by_design - slopes.by_speed * dv_dr;
        entry(0, 1, 1.0);
        entry(1, 0, -k / m);
        entry(1, 1, slopes.by_speed / m);
        Rates {
            f: [v, rate],
            design: [0.0, (by_design - dk * x - rate * dm) / m],
        }
    }

    fn observables(_: &[f64; 5], _: [f64; 2], _: &mut impl ContactRule<f64>) -> [f64; 0] {
        []
    }
}
