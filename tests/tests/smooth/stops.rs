//! Internal states with stops: Jenkins elements against closed forms, against piecewise linear motions, and their
//! derivatives through slips.

use std::f64::consts::{PI, TAU};

use nalgebra::DVector;
use stickslip::continuation::correct;
use stickslip::field::{Design, SmoothField, Smoothing};
use stickslip::flow::{Flow, FlowError, SmoothFamily, SmoothFlow, Want};
use stickslip::integrate::Tolerance;
use stickslip::lyapunov::lyapunov;
use stickslip::model;
use stickslip::model::{Model, ParamId};
use stickslip::motion;
use stickslip::shooting::{Division, OrbitProblem, Phase, closest};
use stickslip::study::{Case, Dynamics, StudyError, System};
use stickslip_models::friction::{Coulomb, Jenkins};
use stickslip_tests::exact;
use stickslip_tests::range::range;

use super::followed::{close, declared, designed, flow, followed};

model! {
    /// A contact that is swung by x = A sin t.
    struct Swung {
        state c = 1.0;
        state s = 0.0;
        state z = 0.0;
        state loss = 0.0;
        param amplitude = 2.0;
        param k = 3.0 where k > 0.0;
        param level = 1.5;
        friction F: 1 = Jenkins { stiffness: k, level } opposing amplitude * c with z;
        let force = -F;
        der(c) = -s;
        der(s) = c;
        der(loss) = -F * amplitude * c;
    }
}

model! {
    /// Two elements at the same contact: a parallel Iwan model.
    struct Iwan {
        state c = 1.0;
        state s = 0.0;
        state z1 = 0.0;
        state z2 = 0.0;
        param amplitude = 2.0;
        param k1 = 2.0 where k1 > 0.0;
        param k2 = 1.0 where k2 > 0.0;
        param level1 = 1.0 where level1 > 0.0;
        param level2 = 1.2 where level2 > 0.0;
        friction F1: 1 = Jenkins { stiffness: k1, level: level1 } opposing amplitude * c with z1;
        friction F2: 1 = Jenkins { stiffness: k2, level: level2 } opposing amplitude * c with z2;
        let force = -F1 - F2;
        let place = amplitude * s;
        der(c) = -s;
        der(s) = c;
    }
}

model! {
    /// A mass between a spring and a Jenkins element, under a harmonic force.
    struct Damped {
        state x = 0.3;
        state v = 0.0;
        state z = 0.1;
        param m = 1.0 where m > 0.0;
        param c = 0.0 where c >= 0.0;
        param spring = 1.0 where spring > 0.0;
        param k = 2.0 where k > 0.0;
        param level = 0.4;
        param load = 1.0;
        param omega = 0.9 where omega > 0.0;
        drive phi at omega;
        friction F = Jenkins { stiffness: k, level } opposing v with z;
        der(x) = v;
        der(v) = (load * cos(phi) - spring * x - c * v + F) / m;
    }
}

model! {
    /// The same with the element in eight parts.
    struct Parts {
        state x = 0.3;
        state v = 0.0;
        state z[8] = 0.0125;
        param c = 0.1;
        param spring = 1.0;
        param k = 2.0 where k > 0.0;
        param level = 0.4;
        param load = 1.0;
        param omega = 0.9 where omega > 0.0;
        drive phi at omega;
        for i in 0..8 {
            friction F[i] = Jenkins { stiffness: k / 8, level: level / 8 } opposing v with z[i];
        }
        der(x) = v;
        der(v) = load * cos(phi) - spring * x - c * v
            + F[0] + F[1] + F[2] + F[3] + F[4] + F[5] + F[6] + F[7];
    }
}

model! {
    /// A contact that slides on, and turns back for an instant in each round.
    struct Hesitating {
        state c = -1.0;
        state s = 0.0;
        state z = 0.0;
        param swing = 1.0005;
        friction F = Jenkins { stiffness: 1.0, level: 0.5 } opposing 1 - swing * c with z;
        let force = F;
        der(c) = -s;
        der(s) = c;
    }
}

model! {
    /// A state that decays too fast for an explicit method, beside a Jenkins element.
    struct Stiff {
        state x = 0.3;
        state v = 0.0;
        state z = 0.1;
        state y = 0.0;
        param level = 0.4;
        param omega = 0.9 where omega > 0.0;
        param rate = 1e6 where rate > 0.0;
        drive phi at omega;
        friction F = Jenkins { stiffness: 2.0, level } opposing v with z;
        der(x) = v;
        der(v) = cos(phi) - x - 0.1 * v + F;
        der(y) = rate * (cos(phi) - y);
    }
}

model! {
    /// A Jenkins element beside dry friction.
    struct Both {
        state x = 0.4;
        state v = 0.0;
        state z = 0.0;
        param level = 0.3 where level >= 0.0;
        friction F = Coulomb { level } opposing v - 0.2;
        friction G = Jenkins { stiffness: 2.0, level: 0.1 } opposing v with z;
        der(x) = v;
        der(v) = F + G - x;
    }
}

model! {
    /// A mass that negative damping excites and a Jenkins element holds.
    struct Excited {
        state x = 0.9;
        state v = 0.0;
        state z = 0.0;
        param excitation = 0.1;
        param k = 2.0 where k > 0.0;
        param level = 1.0;
        friction F = Jenkins { stiffness: k, level } opposing v with z;
        der(x) = v;
        der(v) = excitation * v - x + F;
    }
}

/// 4 F_c (A − F_c/k) in each cycle, and nothing while the spring holds.
#[test]
fn a_cycle_costs_the_area_of_its_loop() {
    for amplitude in [0.3, 0.49, 0.51, 0.8, 2.0, 50.0] {
        let model = Swung {
            amplitude,
            ..Swung::default()
        };
        let first = followed(&model, declared::<Swung, 4>(), TAU, 1e-11);
        let second = followed(&model, first.end.state, TAU, 1e-11);
        let slack = amplitude - model.level / model.k;
        let loss = 4.0 * model.level * slack.max(0.0);
        let found = second.end.state[3] - first.end.state[3];
        close(
            found,
            loss,
            1e-8 * (1.0 + amplitude),
            &format!("A = {amplitude}"),
        );
        let most = model.level.min(model.k * amplitude);
        for sample in &second.path {
            assert!(sample.state[2].abs() <= most * (1.0 + 1e-9), "{sample:?}");
        }
        if slack > 0.0 {
            let rests = second
                .path
                .iter()
                .filter(|s| s.state[2].abs() == model.level);
            assert!(rests.count() > 10, "z drifts on its stop");
        }
    }
}

/// Iwan 1966: branches are the virgin curve, twice as large (Masing 1926).
#[test]
fn parallel_elements_obey_masing() {
    let model = Iwan::default();
    let virgin = |x: f64| (model.k1 * x).min(model.level1) + (model.k2 * x).min(model.level2);
    let field = SmoothField::new(&model, None, Design::None).expect("no friction to smooth");
    let passage = followed(&model, declared::<Iwan, 4>(), 2.5 * PI, 1e-11);
    let (amplitude, most) = (model.amplitude, virgin(model.amplitude));
    for sample in &passage.path {
        let [force, place] = field.observables(&sample.state);
        let expected = if sample.time < 0.5 * PI {
            virgin(place)
        } else if sample.time < 1.5 * PI {
            most - 2.0 * virgin(0.5 * (amplitude - place))
        } else {
            2.0 * virgin(0.5 * (amplitude + place)) - most
        };
        close(force, expected, 2e-9, &format!("force at {}", sample.time));
    }
}

/// The oscillator in closed form from event to event, these found by bisection.
fn piecewise(model: &Damped, mut state: [f64; 3], time: f64) -> [f64; 3] {
    let Damped {
        spring,
        k,
        level,
        load,
        omega,
        m,
        ..
    } = *model;
    // x(t) and v(t) of m ẍ + stiffness x + offset = load cos ωt from x, v at `since`.
    let motion = |since: f64, x: f64, v: f64, stiffness: f64, offset: f64, t: f64| {
        let (own, forced) = (
            (stiffness / m).sqrt(),
            load / (stiffness - m * omega * omega),
        );
        let (a, b) = (
            x - forced * (omega * since).cos() + offset / stiffness,
            (v + forced * omega * (omega * since).sin()) / own,
        );
        let (sin, cos) = (own * (t - since)).sin_cos();
        (
            forced * (omega * t).cos() - offset / stiffness + a * cos + b * sin,
            -forced * omega * (omega * t).sin() + own * (b * cos - a * sin),
        )
    };
    let (mut now, step) = (0.0, 1e-3);
    let mut side = 0.0;
    while now < time {
        let [x0, v0, z0] = state;
        let at = |t: f64| {
            if side == 0.0 {
                let (x, v) = motion(now, x0, v0, spring + k, z0 - k * x0, t);
                [x, v, z0 + k * (x - x0)]
            } else {
                let (x, v) = motion(now, x0, v0, spring, side * level, t);
                [x, v, side * level]
            }
        };
        let goes_on = |t: f64| {
            let [_, v, z] = at(t);
            if side == 0.0 {
                z.abs() < level || z * v < 0.0
            } else {
                side * v > 0.0
            }
        };
        let mut ahead = now + step;
        while ahead < time && goes_on(ahead) {
            ahead += step;
        }
        let (mut low, mut high) = ((ahead - step).max(now), ahead.min(time));
        if goes_on(high) {
            return at(high);
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if goes_on(middle) {
                low = middle
            } else {
                high = middle
            }
        }
        state = at(high);
        side = if side == 0.0 { state[2].signum() } else { 0.0 };
        if side != 0.0 {
            state[2] = side * level;
        }
        now = high;
    }
    state
}

#[test]
fn a_forced_oscillator_is_the_piecewise_linear_one() {
    for (level, omega) in [(0.4, 0.9), (0.1, 0.35), (0.7, 1.6), (5.0, 0.9)] {
        let model = Damped {
            level,
            omega,
            ..Damped::default()
        };
        let passage = followed(&model, declared::<Damped, 4>(), 40.0, 1e-11);
        let reference = piecewise(&model, [0.3, 0.0, 0.1], 40.0);
        for j in 0..3 {
            let what = format!("state {j} at level {level}");
            close(passage.end.state[j], reference[j], 3e-8, &what);
        }
        let slips = level < 1.0;
        let lost = passage.derivatives.expect("wanted").lost;
        assert_eq!(lost, usize::from(slips), "level {level}");
    }
}

/// Φ and ∂φ/∂r through slips against central differences.
fn check_derivatives<M: Model<N>, const N: usize>(
    model: &M,
    start: [f64; N],
    time: f64,
    design: &[usize],
    tolerance: f64,
) {
    let h = 1e-6;
    let slope = |up: [f64; N], down: [f64; N], i: usize| (up[i] - down[i]) / (2.0 * h);
    let end = |model: &M, state| followed(model, state, time, 1e-12).end.state;
    let passage = followed(model, start, time, 1e-12);
    let phi = passage.derivatives.expect("wanted").state;
    for j in 0..N {
        let moved = |by: f64| {
            let mut state = start;
            state[j] += by;
            end(model, state)
        };
        let (up, down) = (moved(h), moved(-h));
        for i in 0..N {
            let expected = slope(up, down, i);
            let tolerance = tolerance * (1.0 + expected.abs());
            close(phi[i][j], expected, tolerance, &format!("Φ[{i}][{j}]"));
        }
    }
    for &index in design {
        let moved = |by: f64| {
            let mut values = model.values();
            values.as_mut()[index] += by;
            end(&M::from_values(values), start)
        };
        let (up, down) = (moved(h), moved(-h));
        let passage = designed(model, Design::Parameter(index), start, time, 1e-12);
        let found = passage.derivatives.expect("wanted").design;
        for i in 0..N {
            let expected = slope(up, down, i);
            let name = M::INFO.parameters[index].name;
            let tolerance = tolerance * (1.0 + expected.abs());
            close(found[i], expected, tolerance, &format!("∂φ/∂{name}[{i}]"));
        }
    }
}

#[test]
fn motions_have_derivatives_through_slips() {
    let index = |id: ParamId<Damped>| id.index;
    let design = [Damped::level, Damped::k, Damped::omega, Damped::load].map(index);
    let start = declared::<Damped, 4>();
    check_derivatives(&Damped::default(), start, 23.0, &design, 2e-6);
    // From the middle of a slip.
    check_derivatives(&Damped::default(), [0.3, 0.5, 0.4, 0.0], 1.0, &design, 2e-6);
    let design = [Iwan::level1.index, Iwan::k2.index, Iwan::amplitude.index];
    check_derivatives(&Iwan::default(), declared::<Iwan, 4>(), 9.0, &design, 2e-6);
    let design = [Stiff::level.index, Stiff::omega.index];
    check_derivatives(
        &Stiff::default(),
        declared::<Stiff, 5>(),
        9.0,
        &design,
        2e-5,
    );
}

/// Elements alike meet and leave their stops together.
#[test]
fn parts_are_a_whole() {
    let whole = Damped {
        c: 0.1,
        ..Damped::default()
    };
    let one = followed(&whole, declared::<Damped, 4>(), 50.0, 1e-11);
    let parts = followed(&Parts::default(), declared::<Parts, 11>(), 50.0, 1e-11);
    let (a, b) = (one.end.state, parts.end.state);
    close(b[0], a[0], 1e-8, "x");
    close(b[1], a[1], 1e-8, "v");
    close(b[2..10].iter().sum(), a[2], 1e-8, "z");
    assert_eq!(one.work.events, parts.work.events);
    let (one, parts) = (
        one.derivatives.expect("wanted"),
        parts.derivatives.expect("wanted"),
    );
    close(parts.state[0][0], one.state[0][0], 1e-6, "Φ");
    close(parts.state[1][0], one.state[1][0], 1e-6, "Φ");
    assert_eq!((one.lost, parts.lost), (1, 8));
}

/// In 0.06 of a round the contact goes back by 2 (a sin t₁ − t₁), cos t₁ = 1/a: between the ends of any long step.
#[test]
fn no_reversal_is_missed() {
    let model = Hesitating::default();
    for accuracy in [1e-4, 1e-7, 1e-10] {
        let passage = followed(&model, declared::<Hesitating, 3>(), 6.5 * PI, accuracy);
        let turn = (1.0 / model.swing).acos();
        let back = 2.0 * (model.swing * turn.sin() - turn);
        let mut minima = passage
            .extrema
            .iter()
            .filter(|e| e.index == 2 && !e.maximum);
        for k in 0..3 {
            let least = minima
                .next()
                .unwrap_or_else(|| panic!("reversal {k} at {accuracy:e}"));
            let reached = 0.5 - least.state[2];
            close(reached, back, 1e-2 * back.max(accuracy), "way back");
            let when = PI + TAU * f64::from(k) + turn;
            close(least.time, when, 1e-3, "time");
        }
        assert!(minima.next().is_none());
        let most = passage.extrema.iter().filter(|e| e.index == 2 && e.maximum);
        assert!(most.clone().count() == 4, "{:?}", most.collect::<Vec<_>>());
    }
}

/// Where the rest of the model is stiff, the implicit method meets the same stops.
#[test]
fn stiff_motions_meet_the_same_stops() {
    let mild = Damped {
        c: 0.1,
        ..Damped::default()
    };
    let reference = followed(&mild, declared::<Damped, 4>(), 40.0, 1e-12);
    let passage = followed(&Stiff::default(), declared::<Stiff, 5>(), 40.0, 1e-10);
    assert!(
        passage.work.factorisations > 0,
        "it is not integrated implicitly"
    );
    for j in 0..3 {
        close(
            passage.end.state[j],
            reference.end.state[j],
            1e-7,
            &format!("state {j}"),
        );
    }
    let (stiff, mild) = (
        passage.derivatives.expect("wanted"),
        reference.derivatives.expect("wanted"),
    );
    assert_eq!((stiff.lost, mild.lost), (1, 1));
    for j in 0..2 {
        close(stiff.state[j][0], mild.state[j][0], 1e-5, "Φ");
    }
}

fn family(model: Damped) -> SmoothFamily<Damped, 4> {
    SmoothFamily {
        model,
        smoothing: None,
        design: Design::None,
        tolerance: Tolerance::for_accuracy(1e-11),
        magnitude: [1.0; 4],
    }
}

/// The response has one exact zero, and Newton squares its corrections.
#[test]
fn the_response_is_shot_for_quadratically() {
    let damped = Damped {
        c: 0.05,
        ..Damped::default()
    };
    let family = family(damped).into();
    let search = exact::search(&declared::<Damped, 4>(), 1e-10);
    let orbit = closest(&family, 0.0, &search).expect("the response");
    close(orbit.period, TAU / 0.9, 1e-9, "period");
    close(orbit.max[2], 0.4, 1e-12, "largest z");
    close(orbit.min[2], -0.4, 1e-12, "smallest z");
    let floquet = &orbit.floquet;
    assert_eq!(floquet.multipliers.len(), 3);
    assert_eq!(floquet.multipliers[2].norm(), 0.0);
    assert_eq!(floquet.log_moduli[2], None);
    assert!(floquet.multipliers[0].norm() < 0.9, "{floquet:?}");

    let mut start = orbit.place.clone();
    start.state[0] += 2e-3;
    start.state[1] -= 3e-3;
    let phase = Phase::floating(
        Some(3),
        orbit.place.state.clone(),
        &DVector::zeros(4),
        &orbit.magnitude(),
    );
    let magnitude = vec![1.0; 4];
    let whole = Division::whole(orbit.place);
    let mut problem = OrbitProblem::new(family, phase, &whole, orbit.period, magnitude);
    let z = OrbitProblem::unknowns(&[start], orbit.period);
    let mut normal = DVector::zeros(6);
    normal[5] = 1.0;
    let found = correct(&mut problem, z, 0.0, &normal, 1.0, 1e-12).expect("convergence");
    let sizes = &found.corrections;
    assert!(sizes[0] > 1e-4, "{sizes:?}");
    for pair in sizes.windows(2).filter(|pair| pair[0] > 1e-6) {
        assert!(pair[1] <= 100.0 * pair[0] * pair[0] + 1e-11, "{sizes:?}");
    }
}

fn case(model: &System, dynamics: Dynamics) -> Case {
    Case::declared(model.info(), dynamics)
}

/// The response is followed; its amplitude and its stability are those of fresh orbits.
#[test]
fn the_response_is_followed_through_resonance() {
    let model = System::of::<Damped, _>();
    let mut case = Case {
        along: Some(range(&model, "omega", 0.7, 1.4)),
        ..case(&model, Dynamics::Smooth)
    };
    case.parameters[Damped::c.index] = 0.1;
    case.parameters[Damped::omega.index] = 0.7;
    let branch = model.branch(&case).expect("a branch");
    assert_eq!(branch.ended.word(), "reached-end");
    let last = branch.points.last().expect("points");
    case.along = None;
    case.parameters[Damped::omega.index] = 1.4;
    let fresh = model.orbit(&case).expect("an orbit");
    close(last.max[0], fresh.max[0], 1e-7, "amplitude");
    let word = |orbit: &stickslip::study::OrbitRecord| orbit.floquet.stability.name();
    assert_eq!(word(last), word(&fresh));
}

#[test]
fn a_start_beyond_a_stop_is_put_on_it() {
    let place = |state| flow(&Damped::default(), Design::None, 1e-9).place(state);
    assert_eq!(place([0.0, 1.0, 7.0, 0.0]).unwrap().state[2], 0.4);
    assert_eq!(place([0.0, 1.0, -7.0, 0.0]).unwrap().state[2], -0.4);
    assert_eq!(place([0.0, 1.0, 0.1, 0.0]).unwrap().state[2], 0.1);
}

#[test]
fn what_cannot_be_is_refused() {
    for level in [0.0, -1.0] {
        let model = Damped {
            level,
            ..Damped::default()
        };
        let error = flow(&model, Design::None, 1e-9)
            .place([0.0; 4])
            .unwrap_err();
        assert!(matches!(error, FlowError::Misplaced { bound, .. } if bound == level));
        assert!(
            error.to_string().starts_with("`Jenkins` stops `z` at"),
            "{error}"
        );
        assert_eq!(family(model).at(0.0).err(), Some(error));
    }
    let error = exact::family(Both::default(), 1e-9)
        .at(0.0)
        .err()
        .expect("a refusal");
    assert!(
        matches!(error, FlowError::NoExactStops { law: "Jenkins" }),
        "{error}"
    );
}

/// A smooth copy of dry friction beside a Jenkins element: explicit and implicit methods agree.
#[test]
fn smooth_copies_go_with_stops() {
    let model = Both::default();
    let end = |smoothing: &str| {
        let smoothing: Smoothing = smoothing.parse().expect("a smoothing");
        let field = SmoothField::new(&model, Some(smoothing), Design::None).expect("accepted");
        let flow = SmoothFlow::new(field, Tolerance::for_accuracy(1e-10));
        let place = flow.place([0.4, 0.0, 0.0]).expect("a place");
        let want = Want {
            derivatives: true,
            ..Want::default()
        };
        flow.advance(&place, 6.0, want).expect("a motion")
    };
    let (mild, steep) = (end("tanh:1e3"), end("tanh:1e5"));
    assert!(steep.work.factorisations > 0);
    for j in 0..3 {
        close(
            mild.end.state[j],
            steep.end.state[j],
            1e-2,
            &format!("state {j}"),
        );
    }
    assert_eq!(steep.derivatives.expect("wanted").lost, 1);
}

/// What the excitation feeds in a round, the slips lose; one multiplier is an exact zero, and the other is the exponent.
#[test]
fn a_self_excited_orbit_is_found_and_judged() {
    let model = System::of::<Excited, _>();
    let orbit = model
        .orbit(&case(&model, Dynamics::Smooth))
        .expect("an orbit");
    let period = orbit.period;
    let amplitude = 0.5 * (orbit.max[0] - orbit.min[0]);
    let flow = flow(&Excited::default(), Design::None, 1e-11);
    let start: [f64; 3] = std::array::from_fn(|j| orbit.state[j]);
    let from = flow.place(start).expect("a place");
    let want = Want {
        path: true,
        ..Want::default()
    };
    let passage = flow.advance(&from, period, want).expect("a motion");
    for j in 0..3 {
        close(passage.end.state[j], start[j], 1e-7, "it closes");
    }
    let fed: f64 = passage
        .path
        .windows(2)
        .map(|pair| {
            let mean = 0.5 * (pair[0].state[1].powi(2) + pair[1].state[1].powi(2));
            0.1 * mean * (pair[1].time - pair[0].time)
        })
        .sum();
    let lost = 4.0 * (amplitude - 0.5);
    assert!(lost > 0.0);
    close(fed, lost, 2e-3 * lost, "energy of a round");

    let floquet = &orbit.floquet;
    assert_eq!(floquet.multipliers.len(), 2);
    assert_eq!(
        (floquet.multipliers[1].norm(), floquet.log_moduli[1]),
        (0.0, None)
    );
    assert!(floquet.trivial_error < 1e-7, "{:e}", floquet.trivial_error);
    assert_eq!(floquet.stability.name(), "stable");
    let from = motion::Flow::place(&flow, &start).expect("a place");
    let exponent = lyapunov(&flow, from, period, 20)
        .expect("an exponent")
        .exponent;
    let expected = floquet.log_moduli[0].expect("not zero") / period;
    close(exponent.expect("one") / expected, 1.0, 1e-4, "exponent");
}

/// At rest any force between the stops will do: equilibria are no points, and motions end where they come to rest.
#[test]
fn rest_is_no_point() {
    let model = System::of::<Excited, _>();
    let mut case = case(&model, Dynamics::Smooth);
    let error = model.equilibria(&case).expect_err("no points");
    assert!(
        matches!(error, StudyError::NotIsolated { law: "Jenkins", .. }),
        "{error}"
    );
    case.parameters[Excited::excitation.index] = -0.5;
    let error = model.orbit(&case).expect_err("it comes to rest");
    assert!(error.to_string().contains("equilibrium"), "{error}");
}
