//! A roller cone bit that lifts off.
//!
//! P. D. Spanos, A. K. Sengupta, R. A. Cunningham, P. R. Paslay, Modeling of roller cone bit lift-off dynamics in rotary
//! drilling, J. Energy Resources Technology 117 (1995) 197: three cones run over a bottom with three lobes, and what they
//! press varies three times a turn. The lowest mode of the string carries the bit, its parameters chosen here; the rock
//! does not give way, and the torque of the bit is friction under the reaction of the rock.

use stickslip::model;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Rigid;

model! {
    /// A bit on a lobed bottom, below the lowest axial and torsional modes of its string.
    pub struct BouncingBit {
        /// Height of the bit above the mean bottom.
        state z: m = 0.02;
        state v: m/s = 0.0;
        /// Twist of the string.
        state psi: rad = 0.0;
        /// Rate of the twist.
        state rate: rad/s = 0.0;
        param mass: kg = 2.0e4 where mass > 0.0;
        param k: N/m = 1.0e6 where k > 0.0;
        param c: N*s/m = 4.0e4 where c >= 0.0;
        /// Static weight on the bit.
        param weight: N = 1.0e5 where weight >= 0.0;
        /// Half the height of the lobes.
        param lobe: m = 0.005 where lobe >= 0.0;
        /// Speed of the cones over the lobes, three times that of the bit.
        param omega: rad/s = 30.0 where omega > 0.0;
        param inertia: kg*m^2 = 300.0 where inertia > 0.0;
        param stiff: N*m = 500.0 where stiff > 0.0;
        param damp: N*m*s = 100.0 where damp >= 0.0;
        /// Torque of the bit over its weight.
        param lever: m = 0.02 where lever >= 0.0;
        param e: 1 = 0.3 where 0.0 <= e <= 1.0;
        drive phi at omega;
        press R: N = Rigid { restitution: e } closing z - lobe * sin(phi);
        friction T: N*m = Coulomb { level: lever * R } opposing omega / 3.0 + rate;
        der(z) = v;
        der(v) = (R - weight - k * z - c * v) / mass;
        der(psi) = rate;
        der(rate) = (T - stiff * psi - damp * rate) / inertia;
    }
}

#[cfg(test)]
mod tests {

    use stickslip::study::Kind;

    use super::BouncingBit;
    use crate::asked::{case, close};

    /// R = W + Re (k − m ω² + icω) a exp(iφ): the rock loses the bit where W = a |k − m ω² + icω|.
    #[test]
    fn the_bit_lifts_off_where_its_inertia_carries_its_weight() {
        let bit = BouncingBit::default();
        let (system, case) = case(&bit);
        let case = case.following(BouncingBit::omega, 25.0..40.0);
        let branch = system.branch(&case);
        let branch = branch.unwrap();
        assert_eq!(branch.points[0].word.as_deref(), Some("slip+(T) rest(R)"));
        // There the reaction just touches zero, and with it the flight's length.
        let [lifts] = branch.special.as_slice() else {
            panic!("{:?}, {}", branch.special, branch.ended.reason)
        };
        assert_eq!(lifts.kind, Kind::Grazing);
        // m² ω⁴ + (c² − 2 k m) ω² + k² − (W/a)² = 0.
        let half = bit.k / bit.mass - 0.5 * (bit.c / bit.mass).powi(2);
        let rest = (bit.k * bit.k - (bit.weight / bit.lobe).powi(2)) / bit.mass.powi(2);
        let closed = (half + (half * half - rest).sqrt()).sqrt();
        close(lifts.r, closed, 1e-8 * closed, "speed of lift-off");
    }
}
