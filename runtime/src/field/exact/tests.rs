use super::*;
use crate::examples::{Belt, Groove, Pad, Pair, Parallel, Sledges, Wrong};
use crate::field::Strip;
use Mode::{SlideBackward, SlideForward, Stick};

fn modes<M: Model<N>, const N: usize>(modes: &[Mode]) -> Modes<M, N> {
    Modes::from_fn(|i| modes[i])
}

fn field_at<M: Model<N>, const N: usize>(model: &M, of: &[Mode], state: [f64; N]) -> Linear<N> {
    let system = ExactSystem::new(model, Some(0));
    let field = ExactField::new(&system, modes(of), &state).unwrap();
    let linear = field.linearise(&state);
    for (a, b) in linear.f.iter().zip(field.f(&state)) {
        assert!((a - b).abs() < 1e-14, "{a} {b}");
    }
    linear
}

/// Jacobian and design column, r being parameter 0, against central differences of f.
fn differences_agree<M: Model<N>, const N: usize>(of: &[Mode], state: [f64; N]) {
    let model = M::default();
    let linear = field_at(&model, of, state);
    let h = 1e-5;
    let f = |shift: f64, y: &[f64; N]| {
        let mut params = model.values();
        params.as_mut()[0] += shift;
        let system = ExactSystem::new(&M::from_values(params), None);
        ExactField::new(&system, modes(of), y).unwrap().f(y)
    };
    let close = |up: [f64; N], down: [f64; N], exact: [f64; N]| {
        for i in 0..N {
            let slope = (up[i] - down[i]) / (2.0 * h);
            assert!((slope - exact[i]).abs() < 1e-8, "{i}: {slope} {}", exact[i]);
        }
    };
    for j in 0..N {
        let (mut up, mut down) = (state, state);
        up[j] += h;
        down[j] -= h;
        let column = crate::scalar::filled(|i| linear.jacobian[i][j]);
        close(f(0.0, &up), f(0.0, &down), column);
    }
    close(f(h, &state), f(-h, &state), linear.design);
}

#[test]
fn derivatives_agree_with_differences_in_every_mode() {
    let all = [SlideForward, SlideBackward, Stick];
    for first in all {
        differences_agree::<Belt, 2>(&[first], [0.6, 0.3]);
        differences_agree::<Groove, 2>(&[first], [0.6, 0.3]);
        for second in all {
            let state = [0.3, 0.2, -0.4, 0.5];
            differences_agree::<Pair, 4>(&[first, second], state);
            differences_agree::<Sledges, 4>(&[first, second], state);
        }
    }
}

#[test]
fn derivatives_agree_with_differences_while_a_press_is_open_or_closed() {
    let rubs = [
        SlideForward,
        SlideBackward,
        Stick,
        Mode::Loose,
        Mode::PinnedForward,
        Mode::PinnedBackward,
    ];
    for rub in rubs {
        for press in [Mode::Open, Mode::Closed, Mode::Parted] {
            // Stages of a step look at both sides of a gap, whatever the mode is.
            for y in [0.3, 0.02] {
                differences_agree::<Pad, 3>(&[rub, press], [y, 0.1, 0.5]);
            }
        }
    }
}

#[test]
fn the_sticking_force_of_the_belt_oscillator_is_that_of_its_spring() {
    let system = ExactSystem::new(&Belt::default(), Some(2));
    let stuck = modes::<Belt, 2>(&[Stick]);
    let snapshot = system.linear(&[0.6, 0.2], &stuck).unwrap();
    assert_eq!(snapshot.force[0].re, 0.6);
    let slopes: ([f64; 2], f64) = snapshot.force[0].slopes();
    assert_eq!(slopes, ([1.0, 0.0], 0.0));
    assert_eq!(
        field_at(&Belt::default(), &[Stick], [0.6, 0.2]).f,
        [0.2, 0.0]
    );
}

#[test]
fn sticking_contacts_do_not_accelerate() {
    let sledges = ExactSystem::new(&Sledges::default(), None);
    let both = modes::<Sledges, 4>(&[Stick, Stick]);
    let state = [0.4, 0.3, 0.2, 0.3];
    let moving = sledges.moving(&state, &both).unwrap();
    for speed in moving.speed {
        assert_eq!(speed.re, 0.0);
        assert!(speed.eps.abs() < 1e-15, "{speed}");
    }
    let second = sledges.second_rates(&state, &both, &moving.field);
    assert!(second.iter().all(|w| w.abs() < 1e-15), "{second:?}");
}

#[test]
fn constants_are_recognised() {
    let known = |system: Option<&[Strip<2>]>| system.map(<[_]>::len);
    assert_eq!(
        known(ExactSystem::new(&Belt::default(), Some(2)).gradients()),
        Some(1)
    );
    // The mass as design variable makes B depend on it.
    assert_eq!(
        known(ExactSystem::new(&Belt::default(), Some(0)).gradients()),
        None
    );
    assert_eq!(
        known(ExactSystem::new(&Groove::default(), None).gradients()),
        None
    );
    assert!(
        ExactSystem::new(&Pair::default(), Some(0))
            .gradients()
            .is_some()
    );
    assert!(
        ExactSystem::new(&Sledges::default(), None)
            .gradients()
            .is_none()
    );
}

#[test]
fn the_correction_returns_to_the_surface() {
    let system = ExactSystem::new(&Sledges::default(), None);
    let mut state = [0.4, 0.31, 0.2, 0.28];
    let field = ExactField::new(&system, modes(&[Stick, Stick]), &state).unwrap();
    let change = field.correction(&state, &system.speeds(&state));
    for (y, c) in state.iter_mut().zip(change) {
        *y -= c;
    }
    assert!(
        (state[1] - 0.3).abs() < 1e-16 && (state[3] - 0.3).abs() < 1e-16,
        "{state:?}"
    );
}

#[test]
fn undetermined_forces_are_refused() {
    let wrong = ExactSystem::new(&Wrong::default(), None);
    let refused = ExactField::new(&wrong, modes(&[Stick]), &[0.1, 0.0]).err();
    assert_eq!(
        refused,
        Some(ContactError::NotOpposing {
            contact: Wrong::INFO.contact_id(0),
            compliance: -1.0
        })
    );
    let parallel = ExactSystem::new(&Parallel::default(), None);
    let refused = ExactField::new(&parallel, modes(&[Stick, Stick]), &[0.1, 0.0]).err();
    assert_eq!(
        refused,
        Some(ContactError::Singular {
            contacts: [0, 1].map(|i| Parallel::INFO.contact_id(i)).to_vec()
        })
    );
    assert!(ExactField::new(&parallel, modes(&[Stick, SlideForward]), &[0.1, 0.0]).is_ok());
}

#[test]
fn forces_are_smooth_where_a_stage_overshoots_the_surface() {
    let at = |v: f64| field_at(&Belt::default(), &[SlideBackward], [0.0, v]);
    let (inside, outside) = (at(0.2 - 1e-7), at(0.2 + 1e-7));
    assert!((inside.f[1] + outside.f[1] - 2.0 * at(0.2).f[1]).abs() < 1e-13);
    assert!((inside.jacobian[1][1] - outside.jacobian[1][1]).abs() < 1e-5);
    assert!(at(5.0).f[1].is_finite() && at(0.2 + 1.0 / 3.0).f[1].abs() < 3.0);
}
