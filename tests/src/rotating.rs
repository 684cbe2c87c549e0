//! A forced oscillator whose orbits are circles, with an isola.

use stickslip::model;

model! {
    /// A forced oscillator that every rotation of its plane leaves as it is: z' = (−d − (|z|² − 1)² + i (1 + b |z|²)) z + F e^{iΩt}.
    /// Its orbits are circles, and with s = |z|² they obey F² = s ((d + (s − 1)²)² + (1 + b s − Ω)²).
    pub struct Rotating {
        state x = 0.9;
        state v = -0.4;
        param d = 0.152 where d > 0.0;
        param b = 0.1;
        param F = 0.25;
        param omega: rad/s = 1.09 where omega > 0.0;
        drive phi at omega;
        let s = powi(x, 2) + powi(v, 2);
        let drop = d + powi(s - 1.0, 2);
        let turn = 1.0 + b * s;
        der(x) = -drop * x - turn * v + F * cos(phi);
        der(v) = turn * x - drop * v + F * sin(phi);
    }
}
