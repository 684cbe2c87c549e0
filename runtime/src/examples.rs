//! Small systems for the unit tests of this crate, each the simplest with the trait that is tested.

use stickslip::{friction_law, model, press_law};

friction_law! {
    /// Weakening with speed, from a level that may lie below the limit at rest.
    pub(crate) struct Weakening {
        /// Largest static force.
        param peak: N where peak >= 0.0;
        /// Force at the beginning of sliding.
        param limit: N where limit >= 0.0;
        /// Rate of weakening.
        param decay: s/m where decay >= 0.0;

        stick = peak;
        slip(s) = limit / (1.0 + decay * s);
    }
}

friction_law! {
    /// A solid that yields before it slides.
    pub(crate) struct Dahl {
        /// Deflection of the bristles.
        state z: m;
        /// Their stiffness.
        param stiffness: N/m where stiffness > 0.0;
        /// Force of steady sliding.
        param level: N where level > 0.0;

        der(z) = w - stiffness * abs(w) * z / level;
        force(w) = stiffness * z;
    }
}

friction_law! {
    /// A spring with a slider: Jenkin 1922.
    pub(crate) struct Jenkins {
        /// Force in the spring.
        state z: N;
        /// Its stiffness.
        param stiffness: N/m where stiffness > 0.0;
        /// Force at which the slider slips.
        param level: N where level > 0.0;

        der(z) = stiffness * w;
        stop z at level;
        force(w) = z;
    }
}

model! {
    /// One mass on a belt, with a limit at rest of its own.
    pub(crate) struct Belt {
        state x = 1.0;
        state v = 0.0;
        param m = 1.0 where m > 0.0;
        param k = 1.0 where k > 0.0;
        param v_dr = 0.2;
        param limit = 1.0 where limit >= 0.0;
        param decay = 3.0 where decay >= 0.0;
        param peak = 1.0 where peak >= 0.0;
        friction F = Weakening { peak: peak, limit: limit, decay: decay } opposing v - v_dr;
        der(x) = v;
        der(v) = (F - k * x) / m;
    }
}

model! {
    /// Two masses on a belt.
    pub(crate) struct Pair {
        state x1 = -0.5976;
        state v1 = 0.0;
        state x2 = -0.4604;
        state v2 = -0.1607;
        param v_dr = 0.14;
        param alpha = 1.2 where alpha >= 0.0;
        param beta = 1.3 where beta > 0.0;
        param peak = 1.0 where peak >= 0.0;
        friction f1 = Weakening { peak: peak, limit: 1.0, decay: 3.0 } opposing v1 - v_dr;
        friction f2 = Weakening { peak: beta * peak, limit: beta, decay: 3.0 } opposing v2 - v_dr;
        let coupling = alpha * (x1 - x2);
        der(x1) = v1;
        der(v1) = f1 - x1 - coupling;
        der(x2) = v2;
        der(v2) = f2 - x2 + coupling;
    }
}

model! {
    /// A sledge on a belt that carries another: the upper contact rubs between them, so G is full, and the
    /// lower mass grows with its place, so G is not constant.
    pub(crate) struct Sledges {
        state x1 = 0.0;
        state v1 = 0.0;
        state x2 = 0.0;
        state v2 = 0.0;
        param v_dr = 0.3;
        param upper = 0.7 where upper > 0.0;
        param peak = 1.2 where peak >= 1.0;
        param growth = 0.2 where growth >= 0.0;
        friction ground = Weakening { peak: peak, limit: 1.0, decay: 2.0 } opposing v1 - v_dr;
        friction between = Weakening { peak: 0.5 * peak, limit: 0.5, decay: 2.0 } opposing v2 - v1;
        der(x1) = v1;
        der(v1) = (ground - between - x1) / (1.0 + growth * x1 * x1);
        der(x2) = v2;
        der(v2) = (between - x2 - 0.3 * x2 * x2 * x2) / upper;
    }
}

model! {
    /// A bead on a belt whose speed depends on the place: w is not affine.
    pub(crate) struct Groove {
        state x = 1.0;
        state v = 0.0;
        param v_dr = 0.3;
        param peak = 1.1 where peak >= 1.0;
        param curvature = 0.2;
        friction F = Weakening { peak: peak, limit: 1.0, decay: 2.0 } opposing v - v_dr * (1.0 + curvature * x * x);
        der(x) = v;
        der(v) = F - x;
    }
}

model! {
    /// A force whose sign is wrong: it pushes the way the contact slides.
    pub(crate) struct Wrong {
        state x = 0.0;
        state v = 0.0;
        param limit = 1.0 where limit >= 0.0;
        friction F = Weakening { peak: limit, limit: limit, decay: 0.0 } opposing v;
        der(x) = v;
        der(v) = -F - x;
    }
}

model! {
    /// Two friction elements in parallel: their forces at rest are not unique.
    pub(crate) struct Parallel {
        state x = 0.0;
        state v = 0.0;
        param limit = 1.0 where limit >= 0.0;
        friction F = Weakening { peak: limit, limit: limit, decay: 0.0 } opposing v;
        friction H = Weakening { peak: limit, limit: limit, decay: 0.0 } opposing v;
        der(x) = v;
        der(v) = F + H - x;
    }
}

model! {
    /// Seven plates on each other, each rubbing on the one below: too many for trying all combinations.
    pub(crate) struct Plates {
        state v1 = 0.0;
        state v2 = 0.0;
        state v3 = 0.0;
        state v4 = 0.0;
        state v5 = 0.0;
        state v6 = 0.0;
        state v7 = 0.0;
        param limit = 1.0 where limit >= 0.0;
        param pull = 1.0;
        friction f1 = Weakening { peak: limit, limit: limit, decay: 0.0 } opposing v1;
        friction f2 = Weakening { peak: limit, limit: limit, decay: 0.0 } opposing v2 - v1;
        friction f3 = Weakening { peak: limit, limit: limit, decay: 0.0 } opposing v3 - v2;
        friction f4 = Weakening { peak: limit, limit: limit, decay: 0.0 } opposing v4 - v3;
        friction f5 = Weakening { peak: limit, limit: limit, decay: 0.0 } opposing v5 - v4;
        friction f6 = Weakening { peak: limit, limit: limit, decay: 0.0 } opposing v6 - v5;
        friction f7 = Weakening { peak: limit, limit: limit, decay: 0.0 } opposing v7 - v6;
        der(v1) = f1 - f2 + pull * -0.37;
        der(v2) = f2 - f3 + pull * 0.74;
        der(v3) = f3 - f4 + pull * -1.11;
        der(v4) = f4 - f5 + pull * 1.48;
        der(v5) = f5 - f6 + pull * -1.85;
        der(v6) = f6 - f7 + pull * 2.22;
        der(v7) = f7 + pull * -2.59;
    }
}

press_law! {
    /// A spring beside a damper.
    pub(crate) struct Bumper {
        param stiffness: N/m where stiffness > 0.0;
        param damping: N*s/m where damping >= 0.0;

        force(d, v) = stiffness * d + damping * v;
    }
}

press_law! {
    /// What does not give way.
    pub(crate) struct Wall {
        param restitution: 1 where 0.0 <= restitution <= 1.0;

        rebound(v) = restitution * v;
    }
}

model! {
    /// A pad that is pressed against a belt as it moves.
    pub(crate) struct Pad {
        state y = 0.1;
        state u = 0.0;
        state v = 0.0;
        param k = 1.3 where k > 0.0;
        param mu = 0.4 where mu >= 0.0;
        param tilt = 0.2;
        press N: 1 = Bumper { stiffness: k, damping: 0.3 } closing 0.05 - y;
        friction F = Weakening { peak: 1.2 * mu * N, limit: mu * N, decay: 0.7 } opposing v - 0.2;
        der(y) = u;
        der(u) = -y - N + tilt * F;
        der(v) = F - k * v;
    }
}
