//! The woodpecker toy.
//!
//! C. Glocker, Dynamik von Starrkörpersystemen mit Reibung und Stössen, VDI 18/182 (1995); R. I. Leine, C. Glocker, D. H.
//! van Campen, Nonlinear dynamics and modeling of various wooden toys with impact and friction, J. Vibration and Control 9
//! (2003) 25. A sleeve slides down a pole, jams and lets go; the bird on its spring hits the pole with its beak. Nothing
//! depends on the height, so that it is no state: a cycle ends lower than it began.

use stickslip::model;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Rigid;

model! {
    /// A woodpecker on a sleeve on a pole: Glocker 1995.
    pub struct Woodpecker {
        /// Angle of the bird.
        state bird = -0.2788;
        /// Angle of the sleeve.
        state sleeve = -0.10344827586206896;
        /// Rate of the height.
        state v = -0.3411;
        state w = 0.0;
        state u = -7.4583;
        param m_sleeve = 0.0003 where m_sleeve > 0.0;
        param j_sleeve = 5.0e-9 where j_sleeve > 0.0;
        param m_bird = 0.0045 where m_bird > 0.0;
        param j_bird = 7.0e-7 where j_bird > 0.0;
        param c = 0.0056 where c > 0.0;
        param g = 9.81;
        /// Radius of the pole, and inner radius and half the height of the sleeve.
        param r_pole = 0.0025;
        param r_sleeve = 0.0031;
        param h_sleeve = 0.0058;
        /// From the middle of the sleeve to the spring, from there to the bird, and from there to its beak.
        param l_sleeve = 0.010;
        param l_bird = 0.015;
        param l_beak = 0.0201;
        param h_beak = 0.020;
        param mu = 0.3 where mu >= 0.0;
        param e_beak = 0.5 where 0.0 <= e_beak <= 1.0;
        let play = r_sleeve - r_pole;
        press N1 = Rigid { restitution: e_beak } closing l_sleeve + l_bird - l_beak - r_pole - h_beak * bird;
        press N2 = Rigid { restitution: 0.0 } closing play + h_sleeve * sleeve;
        press N3 = Rigid { restitution: 0.0 } closing play - h_sleeve * sleeve;
        let reach = l_bird - l_beak;
        friction F1 = Coulomb { level: mu * N1 } opposing v + l_sleeve * w + reach * u;
        friction F2 = Coulomb { level: mu * N2 } opposing v + r_sleeve * w;
        friction F3 = Coulomb { level: mu * N3 } opposing v + r_sleeve * w;
        let q1 = F1 + F2 + F3 - (m_bird + m_sleeve) * g;
        let q2 = h_sleeve * (N2 - N3) + l_sleeve * F1 + r_sleeve * (F2 + F3)
            - c * (sleeve - bird) - m_bird * g * l_sleeve;
        let q3 = reach * F1 - h_beak * N1 - c * (bird - sleeve) - m_bird * g * l_bird;
        let a = m_bird + m_sleeve;
        let b = m_bird * l_sleeve;
        let d = m_bird * l_bird;
        let p = j_sleeve + m_bird * l_sleeve * l_sleeve;
        let q = m_bird * l_sleeve * l_bird;
        let s = j_bird + m_bird * l_bird * l_bird;
        let det = a * (p * s - q * q) - b * (b * s - q * d) + d * (b * q - p * d);
        der(sleeve) = w;
        der(bird) = u;
        der(v) = ((p * s - q * q) * q1 + (d * q - b * s) * q2 + (b * q - d * p) * q3) / det;
        der(w) = ((d * q - b * s) * q1 + (a * s - d * d) * q2 + (b * d - a * q) * q3) / det;
        der(u) = ((b * q - d * p) * q1 + (b * d - a * q) * q2 + (a * p - b * b) * q3) / det;
    }
}

#[cfg(test)]
mod tests {
    use stickslip::flow::exact::ExactFlow;
    use stickslip::flow::{Flow, Want};
    use stickslip::integrate::Tolerance;

    use super::Woodpecker;
    use crate::asked::{case, close};

    /// The published start, of four digits, lies on the cycle to 1 %: where the bird comes by, v and its rate are as given.
    #[test]
    fn the_cycle_passes_the_published_start() {
        let model = Woodpecker::default();
        let (system, mut case) = case(&model);
        let start = vec![-0.2788, -0.10344827586206896, -0.3411, 0.0, -7.4583];
        case.start = Some(start.clone());
        let orbit = system.orbit(&case).unwrap();
        close(orbit.period, 0.14597607, 1e-7, "period");
        let word = orbit.word.as_deref().unwrap();
        assert!(
            word.starts_with("stick(F2) slip-(F2) open(N2) impact(N3) impact(N1)"),
            "{word}"
        );
        let sizes: Vec<f64> = orbit
            .floquet
            .multipliers
            .iter()
            .map(|one| one.norm())
            .collect();
        assert!(sizes[0] < 1.0 && sizes[1..] == [0.0; 3], "{sizes:?}");
        let flow = ExactFlow::new(&model, None, Tolerance::for_accuracy(1e-10)).unwrap();
        let place = flow.place(std::array::from_fn(|j| orbit.state[j])).unwrap();
        let want = Want {
            path: true,
            ..Want::default()
        };
        let passage = flow.advance(&place, orbit.period, want).unwrap();
        let passes = passage.path.windows(2).find_map(|pair| {
            let [a, b] = [&pair[0].state, &pair[1].state];
            let share = (start[0] - a[0]) / (b[0] - a[0]);
            (b[0] < a[0] && (0.0..1.0).contains(&share))
                .then(|| [2, 4].map(|j| a[j] + share * (b[j] - a[j])))
        });
        let [v, u] = passes.expect("the bird comes by");
        close(v, start[2], 0.01 * start[2].abs(), "rate of the height");
        close(u, start[4], 0.01 * start[4].abs(), "rate of the bird");
    }
}
