//! Systems whose normal forces depend on their motion.

use stickslip::field::{Design, SmoothField, Smoothing};
use stickslip::flow::SmoothFlow;
use stickslip::flow::exact::ExactFlow;
use stickslip::integrate::Tolerance;
use stickslip::model;
use stickslip::model::{Model, ParamId};
use stickslip_models::friction::{Coulomb, CoulombStatic};
use stickslip_models::press::{Compliant, Hertz, HuntCrossley, Rigid};

model! {
    /// A mass on a spring beside which, on one side, another stands.
    pub(crate) struct Bilinear {
        state x: m = 0.0;
        state v: m/s = 1.0;
        param mass: kg = 1.0 where mass > 0.0;
        param k: N/m = 1.0 where k > 0.0;
        param wall: N/m = 8.0 where wall > 0.0;
        param c: N*s/m = 0.0 where c >= 0.0;
        param gap: m = 0.0;
        press N: N = Compliant { stiffness: wall, damping: c } closing x + gap;
        der(x) = v;
        der(v) = (N - k * x) / mass;
    }
}

model! {
    /// Mode coupling after Hoffmann, Fischer, Allgaier and Gaul, Wear 253 (2002) 721; y points into the belt.
    pub(crate) struct Squeal {
        state x: m = 0.0;
        state y: m = 0.5;
        state vx: m/s = 0.0;
        state vy: m/s = 0.0;
        param a: N/m = 2.0 where a > 0.0;
        param b: N/m = 0.6666666666666666 where b > 0.0;
        param k12: N/m = 1.0;
        param k3: N/m = 1.3333333333333333 where k3 > 0.0;
        param c1: N*s/m = 0.05 where c1 >= 0.0;
        param c2: N*s/m = 0.05 where c2 >= 0.0;
        param c3: N*s/m = 0.0 where c3 >= 0.0;
        param mass: kg = 1.0 where mass > 0.0;
        param load: N = 1.0;
        param mu: 1 = 0.9 where mu >= 0.0;
        param belt: m/s = 1.0;
        press N: N = Compliant { stiffness: k3, damping: c3 } closing -y;
        friction F: N = Coulomb { level: mu * N } opposing vx - belt;
        der(x) = vx;
        der(y) = vy;
        der(vx) = (F - a * x - k12 * y - c1 * vx) / mass;
        der(vy) = (load - N - k12 * x - b * y - c2 * vy) / mass;
    }
}

model! {
    /// Two masses one above the other: the lower one is hit by a shaken table, and by the upper one, and both rub.
    pub(crate) struct Stack {
        state x1 = 0.2;
        state v1 = 0.0;
        state x2 = 0.5;
        state v2 = 0.0;
        state z1 = 0.0;
        state w1 = 0.3;
        state z2 = 0.0;
        state w2 = -0.2;
        param shake = 0.15 where shake >= 0.0;
        param omega = 1.7 where omega > 0.0;
        param table = 30.0 where table > 0.0;
        param damping = 0.8 where damping >= 0.0;
        param pile = 8.0 where pile > 0.0;
        param exponent = 1.5 where exponent >= 1.0;
        param loss = 0.3 where loss >= 0.0;
        param gravity = 1.0 where gravity >= 0.0;
        param mu = 0.4 where mu >= 0.0;
        param peak = 1.2 where peak >= 1.0;
        param adhesion = 0.05 where adhesion >= 0.0;
        param tie = 0.6 where tie >= 0.0;
        drive phi at omega;
        press T = Compliant { stiffness: table, damping } closing x1 - shake * sin(phi);
        press P = HuntCrossley { load: pile, depth: 0.3, exponent, damping: loss } closing x2 - x1 - 0.1;
        friction F = CoulombStatic { static_level: peak * mu * T, kinetic_level: mu * T } opposing w1 - 0.1;
        friction G = Coulomb { level: mu * P + adhesion } opposing w2 - w1;
        der(x1) = v1;
        der(v1) = T - P - gravity - 0.3 * x1 * x1 * x1;
        der(x2) = v2;
        der(v2) = (P - gravity) / 0.7 - 0.2 * x2;
        der(z1) = w1;
        der(w1) = F - G - tie * z1;
        der(z2) = w2;
        der(w2) = (G - tie * z2) / 0.7;
    }
}

model! {
    /// A ball between two round walls, tied to the ground.
    pub(crate) struct Ball {
        state x = 0.0;
        state v = 1.0;
        param left = 3.0 where left > 0.0;
        param right = 5.0 where right > 0.0;
        param curve = 0.2;
        press L = Hertz { load: left, depth: 0.2 } closing x + 0.5 + curve * x * x;
        press R = Hertz { load: right, depth: 0.2 } closing 0.7 - x;
        der(x) = v;
        der(v) = L - R - 0.5 * x;
    }
}

model! {
    /// A driven oscillator beside a wall.
    pub(crate) struct Hammer {
        state x = 0.0;
        state v = 0.0;
        param load = 1.0;
        param omega = 1.0 where omega > 0.0;
        param c = 0.1 where c >= 0.0;
        param k = 1.0 where k > 0.0;
        param wall = 1.0;
        param e = 0.8 where 0.0 < e <= 1.0;
        drive phi at omega;
        press R = Rigid { restitution: e } closing wall - x;
        der(x) = v;
        der(v) = load * cos(phi) - k * x - c * v - R;
    }
}

model! {
    /// A ball on a table that moves up and down.
    pub(crate) struct Bouncing {
        state y = 1.0;
        state v = 0.0;
        param amplitude = 0.5;
        param e = 0.8 where 0.0 < e <= 1.0;
        param omega = 1.0 where omega > 0.0;
        param g = 1.0 where g > 0.0;
        drive phi at omega;
        press R = Rigid { restitution: e } closing y - amplitude * sin(phi);
        der(y) = v;
        der(v) = R - g;
    }
}

model! {
    /// Two masses in a row, shaken from one side, hit by each other, and rubbing on ground that moves.
    pub(crate) struct Rattle {
        state x1 = 0.3;
        state v1 = 0.0;
        state x2 = 0.9;
        state v2 = 0.0;
        param shake = 0.2 where shake >= 0.0;
        param omega = 1.7 where omega > 0.0;
        param e1 = 0.7 where 0.0 < e1 <= 1.0;
        param e2 = 0.5 where 0.0 < e2 <= 1.0;
        param m2 = 0.6 where m2 > 0.0;
        param rough = 0.1 where rough >= 0.0;
        param spring = 0.7;
        param k = 9.0 where k > 0.0;
        drive phi at omega;
        press A = Rigid { restitution: e1 } closing x1 - shake * sin(phi);
        press B = Rigid { restitution: e2 } closing x2 - x1 - 0.1 * (1.0 + 0.2 * x1 * x1);
        press C = Compliant { stiffness: k, damping: 0.3 } closing 1.2 - x2;
        friction F = Coulomb { level: rough } opposing v1 - 0.15;
        der(x1) = v1;
        der(v1) = A - B * (1.0 + 0.04 * x1 * x1) + F - spring * x1;
        der(x2) = v2;
        der(v2) = (B - C - spring * (x2 - 1.0)) / m2;
    }
}

model! {
    /// Two balls tied to each other on a table that moves up and down.
    pub(crate) struct Shelf {
        state y1 = 1.0;
        state v1 = 0.0;
        state y2 = 1.2;
        state v2 = 0.0;
        param shake = 0.5;
        param omega = 1.3 where omega > 0.0;
        param e1 = 0.5 where 0.0 <= e1 <= 1.0;
        param e2 = 0.4 where 0.0 <= e2 <= 1.0;
        param mass = 1.5 where mass > 0.0;
        param tie = 0.3;
        param drag = 0.1;
        param g = 1.0;
        drive phi at omega;
        press A = Rigid { restitution: e1 } closing y1 - shake * sin(phi);
        press B = Rigid { restitution: e2 } closing y2 + 0.1 * y2 * y2 - shake * cos(phi);
        let spring = tie * (y2 - y1) + drag * (v2 - v1);
        der(y1) = v1;
        der(v1) = A + spring - g;
        der(y2) = v2;
        der(v2) = (B * (1.0 + 0.2 * y2) - spring) / mass - g;
    }
}

model! {
    /// A mass on another one on the ground.
    pub(crate) struct Tower {
        state y1 = 0.0;
        state v1 = 0.0;
        state y2 = 1.0;
        state v2 = 0.0;
        param e = 0.5 where 0.0 <= e <= 1.0;
        param mass = 2.0 where mass > 0.0;
        press A = Rigid { restitution: e } closing y1;
        press B = Rigid { restitution: e } closing y2 - y1 - 1.0;
        der(y1) = v1;
        der(v1) = A - B - 1.0;
        der(y2) = v2;
        der(v2) = B / mass - 1.0;
    }
}

model! {
    /// A block on a shaken ramp, on whose surface a belt runs.
    pub(crate) struct Ramp {
        state x = 0.0;
        state u = 0.0;
        state y = 0.5;
        state v = 0.0;
        param shake = 0.5;
        param omega = 1.3 where omega > 0.0;
        param e = 0.3 where 0.0 <= e <= 1.0;
        param mu = 0.4 where mu >= 0.0;
        param slope = 0.2;
        param wide = 0.8 where wide > 0.0;
        param belt = 0.2;
        param k = 1.0;
        param g = 1.0;
        drive phi at omega;
        press R = Rigid { restitution: e } closing y - slope * x - shake * sin(phi);
        friction F = Coulomb { level: mu * R } opposing u + slope * v - belt;
        der(x) = u;
        der(u) = (F - slope * R - k * x) / wide;
        der(y) = v;
        der(v) = R + slope * F - g;
    }
}

model! {
    /// The pressure relief valve of Hos and Champneys.
    pub(crate) struct Valve {
        state y = 2.4;
        state v = 0.0;
        state p = 12.4;
        param kappa = 1.25;
        param delta = 10.0;
        param beta = 20.0;
        param q = 9.0;
        param r = 0.8 where 0.0 < r <= 1.0;
        press R = Rigid { restitution: r } closing y;
        der(y) = v;
        der(v) = -kappa * v - (y + delta) + p + R;
        der(p) = beta * (q - y * sqrt(p));
    }
}

pub(crate) const TIGHT: Tolerance = Tolerance {
    relative: 1e-13,
    absolute: 1e-13,
};

pub(crate) fn flow<M: Model<N>, const N: usize>(
    model: &M,
    design: Option<usize>,
) -> ExactFlow<M, N> {
    ExactFlow::new(model, design.map(ParamId::new), TIGHT).unwrap()
}

pub(crate) fn copy<M: Model<N>, const N: usize>(
    model: &M,
    smoothing: Smoothing,
    design: Design,
) -> SmoothFlow<M, N> {
    let field = SmoothField::new(model, Some(smoothing), design);
    SmoothFlow::new(field.unwrap(), TIGHT)
}

/// How much smaller an error is at the second of two sizes.
pub(crate) fn falls(sizes: [f64; 2], error: impl Fn(f64) -> f64) -> f64 {
    let [coarse, fine] = sizes.map(error);
    assert!(fine.abs() > 0.0);
    coarse / fine
}
