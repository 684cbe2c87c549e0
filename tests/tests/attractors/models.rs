//! Systems with several motions whose shares are published.

use stickslip::{friction_law, model};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::{Compliant, Rigid};

friction_law! {
    /// Friction that falls exponentially from rest to fast sliding.
    pub struct Decaying {
        param sliding: N where sliding >= 0.0;
        param ratio where ratio >= 0.0;
        param scale: m/s where scale > 0.0;
        stick = ratio * sliding;
        slip(w) = sliding * (1.0 + (ratio - 1.0) * exp(-w / scale));
    }
}

model! {
    /// The friction oscillator of bSTAB (Stender & Hoffmann 2022, Nonlinear Dynamics 107, 1451).
    pub struct FrictionOscillator {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param v_d: m/s = 1.5;
        param xi: N*s/m = 0.05;
        param mu_d: N = 0.5;
        param ratio = 2.0;
        param v_0: m/s = 0.5;
        param mass: kg = 1.0;
        param k: N/m = 1.0;
        friction F: N = Decaying { sliding: mu_d, ratio: ratio, scale: v_0 } opposing v - v_d;
        der(x) = v;
        der(v) = (F - k * x - 2.0 * xi * v) / mass;
    }
}

model! {
    /// A damped pendulum under a torque: it rests, or it turns.
    pub struct Pendulum {
        state x = 0.0;
        state v = 0.0;
        param alpha = 0.1;
        param T = 0.5;
        param K = 1.0;
        der(x) = v;
        der(v) = T - alpha * v - K * sin(x);
    }
}

model! {
    /// A forced oscillator with a cubic spring and five stable motions.
    pub struct Duffing {
        state x = 0.0;
        state v = 0.0;
        param delta = 0.08;
        param k3 = 1.0;
        param A = 0.2;
        drive phi at 1.0;
        der(x) = v;
        der(v) = A * cos(phi) - delta * v - k3 * powi(x, 3);
    }
}

model! {
    /// A shaken mass that a spring presses the harder, the further it is (Feeny & Moon 1994, J. Sound Vib. 170, 303).
    pub struct Pressed {
        state x = 0.5;
        state v = 0.0;
        param zeta = 0.015;
        param k = 1.5;
        param a = 1.9;
        param mu = 1.0 where mu >= 0.0;
        drive phi at 1.25;
        press N = Compliant { stiffness: k, damping: 0.0 } closing -1.0 / k - x;
        friction F = Coulomb { level: mu * N } opposing v;
        der(x) = v;
        der(v) = F - 2.0 * zeta * v - x + a * cos(phi);
    }
}

model! {
    /// A ball that is slowed down between a wall that moves and one that does not.
    pub struct Slowed {
        state x = 0.5;
        state v = 1.0;
        param drag = 0.5;
        param e = 0.9 where 0.0 <= e <= 1.0;
        drive phi at 6.0;
        press Left = Rigid { restitution: e } closing x - 0.05 * cos(phi);
        press Right = Rigid { restitution: e } closing 1.0 - x;
        der(x) = v;
        der(v) = Left - Right - drag * v;
    }
}
