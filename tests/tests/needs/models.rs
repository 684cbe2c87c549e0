//! Structures under a harmonic force, with dry contacts. Of each, all modes that there are are kept.

use stickslip::model;
use stickslip_models::friction::Coulomb;

model! {
    /// Six masses in a row, one of which rubs.
    pub struct Chain {
        structure chain = "tests/needs/chain.structure";
        param push: N = 1.0;
        param level: N = 0.4 where level >= 0.0;
        param omega: rad/s = 0.35 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level } opposing der(chain.rub);
        load chain.rub = F;
        load chain.end = push * cos(phi);
    }
}

model! {
    /// Six masses of different size between two walls, two of which rub.
    pub struct Graded {
        structure chain = "tests/needs/graded.structure";
        param push: N = 1.0;
        param level: N = 0.1 where level >= 0.0;
        param omega: rad/s = 0.9 where omega > 0.0;
        drive phi at omega;
        friction left: N = Coulomb { level } opposing der(chain.left);
        friction right: N = Coulomb { level: 0.5 * level } opposing der(chain.right);
        load chain.left = left;
        load chain.right = right;
        load chain.middle = push * cos(phi);
    }
}

model! {
    /// A cantilever that rubs inside, with a mass on a spring at its tip.
    pub struct Cantilever {
        structure beam = "tests/needs/cantilever.structure";
        state x: m = 0.0;
        state v: m/s = 0.0;
        param push: N = 1.0;
        param level: N = 0.5 where level >= 0.0;
        param k: N/m = 2.0 where k > 0.0;
        param c: N*s/m = 0.2 where c >= 0.0;
        param m: kg = 0.3 where m > 0.0;
        param omega: rad/s = 1.7 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level } opposing der(beam.rub);
        let pull = k * (x - beam.tip) + c * (v - der(beam.tip));
        load beam.rub = F;
        load beam.tip = push * cos(phi) + pull;
        der(x) = v;
        der(v) = -pull / m;
    }
}

model! {
    /// A beam between two supports, rubbing at two places.
    pub struct Bridge {
        structure beam = "tests/needs/bridge.structure";
        param push: N = 1.0;
        param level: N = 0.2 where level >= 0.0;
        param omega: rad/s = 6.0 where omega > 0.0;
        drive phi at omega;
        friction left: N = Coulomb { level } opposing der(beam.left);
        friction right: N = Coulomb { level: 2.0 * level } opposing der(beam.right);
        load beam.left = left;
        load beam.right = right;
        load beam.push = push * cos(phi);
    }
}

model! {
    /// A rod that is pulled at its end and rubs inside.
    pub struct Rod {
        structure rod = "tests/needs/rod.structure";
        param push: N = 1.0;
        param level: N = 0.3 where level >= 0.0;
        param omega: rad/s = 1.1 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level } opposing der(rod.rub);
        load rod.rub = F;
        load rod.end = push * cos(phi);
    }
}

model! {
    /// The same rod by four of the modes that its file has.
    pub struct ShortRod {
        structure rod = "tests/needs/rod.structure" keeping 4;
        param push: N = 1.0;
        param level: N = 0.3 where level >= 0.0;
        param omega: rad/s = 1.1 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level } opposing der(rod.rub);
        load rod.rub = F;
        load rod.end = push * cos(phi);
    }
}
