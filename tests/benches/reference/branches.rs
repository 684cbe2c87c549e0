//! Whole branches of orbits, with every multiplier.

use std::time::{Duration, Instant};

use stickslip::continuation::{Settings, Stop};
use stickslip::field::{Design, Smoothing, Work};
use stickslip::flow::SmoothFamily;
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::motion::Family;
use stickslip::shooting::{Orbit, OrbitBranch, Search, closest};
use stickslip_models::{BeltOscillator, VanDerPol};

/// A branch as it is asked for: r through these values, to this accuracy.
struct Route {
    family: Family,
    search: Search,
    stops: Vec<f64>,
}

pub(crate) fn table() {
    println!("\nwhole branches with every multiplier");
    println!(
        "{:<26}{:>8}{:>8}{:>9}{:>9}{:>8}{:>8}{:>10}{:>9}",
        "", "ms", "wanted", "first ms", "points", "Newton", "steps", "rejected", "ended"
    );
    let nu = Design::Parameter(VanDerPol::nu.index);
    let van_der_pol = route(
        VanDerPol::default(),
        nu,
        None,
        1e-9,
        vec![1.0, 5.0, 10.0, 15.0],
    );
    row("van-der-pol nu 1..15", &van_der_pol, 10.0);
    for exponent in 2..=7 {
        let smoothing = format!("arctan:1e{exponent}");
        let v_dr = Design::Parameter(BeltOscillator::v_dr.index);
        let parsed = smoothing.parse().ok();
        let belt = route(
            BeltOscillator::default(),
            v_dr,
            parsed,
            1e-7,
            vec![0.2, 0.055],
        );
        row(&format!("belt {smoothing} 0.2..0.055"), &belt, 100.0);
    }
    digits(&van_der_pol);
}

fn route<M: Model<N>, const N: usize>(
    model: M,
    design: Design,
    smoothing: Option<Smoothing>,
    accuracy: f64,
    stops: Vec<f64>,
) -> Route {
    let family = SmoothFamily {
        model,
        smoothing,
        design,
        tolerance: Tolerance::for_accuracy(accuracy),
        magnitude: [1.0; N],
    };
    Route {
        family: family.into(),
        search: Search {
            start: M::INFO.states.iter().map(|state| state.start).collect(),
            modes: Vec::new(),
            period: None,
            accuracy,
            segments: 1,
        },
        stops,
    }
}

impl Route {
    fn first(&self) -> Orbit {
        closest(&self.family, self.stops[0], &self.search).expect("a first orbit")
    }

    /// Every orbit, and whether the end was reached; the last of a stretch is the first of the next.
    fn follow(&self, first: &Orbit) -> (Vec<Orbit>, bool) {
        let (mut orbits, mut reached) = (vec![first.clone()], true);
        for ends in self.stops.windows(2) {
            let settings = Settings::new(ends[0], ends[1], self.search.accuracy);
            let last = orbits.pop().expect("an orbit");
            let branch = OrbitBranch::start(&self.family, &last, &self.search, settings);
            let mut branch = branch.expect("a branch");
            orbits.extend(branch.by_ref());
            reached &= matches!(branch.stop(), Some(Stop::ReachedEnd));
        }
        (orbits, reached)
    }
}

fn row(name: &str, route: &Route, wanted: f64) {
    let begin = Instant::now();
    let first = route.first();
    let found = begin.elapsed().as_secs_f64();
    let (orbits, reached) = route.follow(&first);
    let mut work = Work::default();
    orbits.iter().for_each(|orbit| work += orbit.work);
    let seconds = super::clock::best(Duration::from_secs(2), || {
        std::hint::black_box(route.follow(std::hint::black_box(&first)));
    });
    println!(
        "{name:<26}{:>8.2}{wanted:>8}{:>9.2}{:>9}{:>8}{:>8}{:>10}{:>9}",
        seconds * 1e3,
        found * 1e3,
        orbits.len(),
        work.newton,
        work.steps,
        work.rejected,
        if reached { "end" } else { "early" },
    );
}

/// T, max |x| and max |ẋ| of the branch's points against orbits computed tighter by far.
fn digits(route: &Route) {
    println!("\nVan der Pol's branch against a tighter run (1e-9 is wanted)");
    println!("{:<26}{:>10}{:>10}{:>10}", "", "T", "max |x|", "max |v|");
    let (orbits, _) = route.follow(&route.first());
    let search = Search {
        accuracy: 1e-13,
        ..route.search.clone()
    };
    for nu in [5.0, 10.0, 15.0] {
        let point = orbits
            .iter()
            .find(|orbit| orbit.r == nu)
            .expect("a point at each stop");
        let truth = closest(&route.family, nu, &search).expect("a tight orbit");
        let error = |a: f64, b: f64| (a / b - 1.0).abs();
        println!(
            "{:<26}{:>10.1e}{:>10.1e}{:>10.1e}",
            format!("  nu = {nu}"),
            error(point.period, truth.period),
            error(point.max_abs()[0], truth.max_abs()[0]),
            error(point.max_abs()[1], truth.max_abs()[1]),
        );
    }
}
