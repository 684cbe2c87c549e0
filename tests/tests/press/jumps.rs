//! Derivatives through contacts that do not give way: impacts, chatter, rest and release.

use stickslip::model;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::{Compliant, Rigid};
use stickslip_tests::random::Random;

use crate::derivatives::{happened, tally};
use crate::models::{Ramp, Rattle, Shelf};

model! {
    /// Three coordinates of any inertia: a wall that shakes, a pad that gives way, and a belt, each in a direction of its own.
    struct Coupled {
        state x = 0.0;
        state y = 0.0;
        state z = 0.0;
        state u = 0.0;
        state v = 0.0;
        state w = 0.0;
        param axx = 1.0;
        param axy = 0.0;
        param axz = 0.0;
        param ayy = 1.0;
        param ayz = 0.0;
        param azz = 1.0;
        param nx = 1.0;
        param ny = 0.0;
        param nz = 0.0;
        param tx = 0.0;
        param ty = 1.0;
        param tz = 0.0;
        param sx = 0.0;
        param sy = 0.0;
        param sz = 1.0;
        param gap = 0.4;
        param room = 0.2;
        param e = 0.3 where 0.0 <= e <= 1.0;
        param pad = 8.0 where pad > 0.0;
        param damping = 0.2 where damping >= 0.0;
        param under_wall = 0.2 where under_wall >= 0.0;
        param under_pad = 0.2 where under_pad >= 0.0;
        param push = 1.0;
        param belt = 0.1;
        param shake = 0.2;
        param omega = 1.5 where omega > 0.0;
        drive phi at omega;
        press R = Rigid { restitution: e } closing gap + nx * x + ny * y + nz * z - shake * sin(phi);
        press C = Compliant { stiffness: pad, damping } closing room + sx * x + sy * y + sz * z;
        friction F = Coulomb { level: under_wall * R + under_pad * C } opposing tx * u + ty * v + tz * w - belt;
        let fx = nx * (R - push) + sx * C + tx * F - x - 0.1 * u;
        let fy = ny * (R - push) + sy * C + ty * F - y - 0.1 * v;
        let fz = nz * (R - push) + sz * C + tz * F - z - 0.1 * w;
        der(x) = u;
        der(y) = v;
        der(z) = w;
        der(u) = axx * fx + axy * fy + axz * fz;
        der(v) = axy * fx + ayy * fy + ayz * fz;
        der(w) = axz * fx + ayz * fy + azz * fz;
    }
}

/// A direction of length one.
fn direction(random: &mut Random) -> [f64; 3] {
    let way: [f64; 3] = random.array(|random| random.real(1.0));
    let length = way.iter().map(|x| x * x).sum::<f64>().sqrt();
    way.map(|x| x / length)
}

/// Random directions and inertia, friction mostly across the wall; without a pad two contacts, with it three. What the pad
/// presses may stick while the wall is left.
fn coupled(random: &mut Random, pad: bool) -> Coupled {
    let [n, s, across] = [0; 3].map(|_| direction(random));
    let along: f64 = n.iter().zip(&across).map(|(n, t)| n * t).sum();
    let t: [f64; 3] = std::array::from_fn(|i| across[i] - 0.8 * along * n[i]);
    let l: [f64; 3] = random.array(|random| random.real(0.4));
    let d: [f64; 3] = random.array(|random| random.between(0.8, 1.2));
    Coupled {
        axx: d[0] * d[0],
        axy: d[0] * l[0],
        axz: d[0] * l[1],
        ayy: l[0] * l[0] + d[1] * d[1],
        ayz: l[0] * l[1] + d[1] * l[2],
        azz: l[1] * l[1] + l[2] * l[2] + d[2] * d[2],
        nx: n[0],
        ny: n[1],
        nz: n[2],
        tx: t[0],
        ty: t[1],
        tz: t[2],
        sx: s[0],
        sy: s[1],
        sz: s[2],
        room: if pad { random.between(0.0, 0.1) } else { 10.0 },
        e: random.between(0.1, 0.5),
        pad: 12.0,
        damping: random.between(0.1, 0.5),
        under_wall: random.between(0.2, 0.5),
        under_pad: if pad { 2.0 } else { 0.0 },
        push: random.between(0.5, 1.5),
        belt: random.real(0.1),
        shake: random.between(0.15, 0.75),
        omega: random.between(1.0, 2.5),
        ..Default::default()
    }
}

#[test]
fn through_two_and_three_contacts_in_random_directions() {
    for pad in [false, true] {
        let tally = tally(60, |random| {
            let model = coupled(random, pad);
            let mut start = [0.0; 7];
            for (i, component) in start[..6].iter_mut().enumerate() {
                *component = random.real(if i < 3 { 0.15 } else { 0.6 });
            }
            (model, start, random.between(2.0, 8.0))
        });
        let rigid = [
            "impact R",
            "settling R",
            "opening R",
            "landing F",
            "release F",
        ];
        happened(&tally, &rigid);
        if pad {
            happened(&tally, &["closing C", "parting C", "loss R", "loss C"]);
        }
    }
}

#[test]
fn through_impacts() {
    let tally = tally(40, |random| {
        let model = Rattle {
            shake: random.between(0.05, 0.3),
            omega: random.between(1.0, 3.0),
            e1: random.between(0.3, 0.95),
            e2: random.between(0.3, 0.95),
            m2: random.between(0.3, 2.0),
            rough: random.between(0.3, 0.8),
            ..Default::default()
        };
        let mut start = [0.4, 0.0, 0.9, 0.0, 0.0];
        for component in &mut start[..4] {
            *component += random.real(0.2);
        }
        start[1] += random.real(1.5);
        start[3] += random.real(1.5);
        (model, start, random.between(2.0, 5.0))
    });
    let events = [
        "impact A",
        "impact B",
        "closing C",
        "parting C",
        "landing F",
        "release F",
    ];
    happened(&tally, &events);
}

#[test]
fn through_rest_on_a_shaken_shelf() {
    let tally = tally(30, |random| {
        let model = Shelf {
            shake: random.between(0.3, 1.0),
            omega: random.between(1.0, 2.0),
            e1: random.between(0.2, 0.6),
            e2: random.between(0.2, 0.6),
            mass: random.between(0.5, 2.0),
            tie: random.between(0.1, 0.6),
            ..Default::default()
        };
        let mut start = [1.0, 0.0, 1.8, 0.0, 0.0];
        for component in &mut start[..4] {
            *component += random.real(0.4);
        }
        (model, start, random.between(3.0, 10.0))
    });
    let events = [
        "impact A",
        "impact B",
        "settling A",
        "settling B",
        "opening A",
        "opening B",
    ];
    happened(&tally, &events);
}

#[test]
fn through_friction_on_a_shaken_ramp() {
    let tally = tally(40, |random| {
        let model = Ramp {
            shake: random.between(0.2, 1.2),
            omega: random.between(1.0, 2.0),
            e: random.between(0.1, 0.5),
            mu: random.between(0.2, 0.7),
            slope: random.real(0.4),
            wide: random.between(0.6, 1.5),
            belt: random.real(0.5),
            ..Default::default()
        };
        let mut start = [0.0, 0.0, 0.8, 0.0, 0.0];
        for component in &mut start[..4] {
            *component += random.real(0.4);
        }
        (model, start, random.between(2.0, 8.0))
    });
    let events = [
        "impact R",
        "settling R",
        "opening R",
        "landing F",
        "release F",
    ];
    happened(&tally, &events);
}
