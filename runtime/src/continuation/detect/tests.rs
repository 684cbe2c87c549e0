use super::*;

/// A multiplier is known to this.
const MARGIN: f64 = 1e-9;

/// A point of which only the multipliers count.
#[derive(Debug, Clone)]
struct Point {
    r: f64,
    multipliers: [f64; 3],
}

impl Watched for Point {
    fn r(&self) -> f64 {
        self.r
    }

    fn r_scale(&self) -> f64 {
        self.r.abs()
    }

    fn slope(&self) -> f64 {
        1.0
    }

    fn unstable(&self) -> usize {
        let outside = |mu: &&f64| mu.abs() >= 1.0 + MARGIN;
        self.multipliers.iter().filter(outside).count()
    }

    fn growing_beside(&self, kind: Kind) -> Option<usize> {
        let at = if kind == Kind::Flip { -1.0 } else { 1.0 };
        let outside = |mu: &&f64| mu.abs() > 1.0 && (*mu - at).abs() > 1e-6;
        Some(self.multipliers.iter().filter(outside).count())
    }

    fn marginal(&self) -> Option<usize> {
        let near = |mu: &&f64| (mu.abs() - 1.0).abs() < MARGIN;
        Some(self.multipliers.iter().filter(near).count())
    }

    fn same_regime(&self, other: &Self) -> bool {
        let regime = |mu: f64| if mu < 2.0 { f64::from(mu >= 0.25) } else { mu };
        let [own, others] = [self, other].map(|point| regime(point.multipliers[2]));
        own == others
    }
}

/// (1 + μ₁) (1 + μ₂) (1 + μ₃).
fn flip(point: &Point) -> f64 {
    point.multipliers.iter().map(|mu| 1.0 + mu).product()
}

/// (1 − μ₁) (1 − μ₂) (1 − μ₃).
fn one(point: &Point) -> f64 {
    point.multipliers.iter().map(|mu| 1.0 - mu).product()
}

/// A branch along r from 0 to 1 with these multipliers; between its ends it can be looked at as far as `known`.
struct Along {
    multipliers: fn(f64) -> [f64; 3],
    known: bool,
}

impl Along {
    fn point(&self, r: f64) -> Point {
        Point {
            r,
            multipliers: (self.multipliers)(r),
        }
    }

    fn findings(mut self) -> Findings<Point> {
        let ends = [0.0, 1.0].map(|r| self.point(r));
        let monitors = vec![
            Monitor::new(Kind::Flip, flip),
            Monitor::new(Kind::BranchPoint, one),
        ];
        detect(&mut self, &monitors, [&ends[0], &ends[1]], 1e-9)
    }
}

impl Path for Along {
    type Point = Point;
    type Error = &'static str;

    fn at(&mut self, share: f64) -> Result<Point, &'static str> {
        self.known
            .then(|| self.point(share))
            .ok_or("nobody knows what lies here")
    }
}

/// Two flips on one step leave the sign of the test function as it was: only the count tells. Halving meets both exactly.
fn twice(r: f64) -> [f64; 3] {
    [-0.9 - 0.2 * r, -0.85 - 0.2 * r, 0.0]
}

#[test]
fn two_flips_on_one_step_are_found_by_their_count() {
    let found = Along {
        multipliers: twice,
        known: true,
    };
    let found = found.findings();
    assert!(found.unexplained.is_empty(), "{:?}", found.unexplained);
    let flips: Vec<(Kind, f64)> = found.located.iter().map(|at| (at.kind, at.r)).collect();
    assert_eq!(flips.len(), 2, "{flips:?}");
    for ((kind, r), expected) in flips.into_iter().zip([0.5, 0.75]) {
        assert_eq!(kind, Kind::Flip);
        assert!((r - expected).abs() < 1e-8, "{r}, not {expected}");
    }
}

/// Where the multiplier that passes is not known well enough all along a step, no count shows it.
#[test]
fn a_flip_is_told_of_a_multiplier_that_is_marginal_at_both_ends() {
    let found = Along {
        multipliers: |r| [-1.0 - 0.4 * MARGIN * (r - 0.3), 1.5, 0.0],
        known: true,
    };
    let found = found.findings();
    assert!(found.unexplained.is_empty(), "{:?}", found.unexplained);
    let [flip] = &found.located[..] else {
        panic!("{:?}", found.located);
    };
    assert!((flip.r - 0.3).abs() < 1e-6, "{flip:?}");
}

/// One direction that is lost and two that are won look like one that is won at the point where it passes 1.
#[test]
fn one_direction_does_not_stand_for_three() {
    let found = Along {
        multipliers: |r| [-0.9 - 0.2 * r, -0.85 - 0.2 * r, 1.03 - 0.1 * r],
        known: true,
    };
    let found = found.findings();
    assert!(found.unexplained.is_empty(), "{:?}", found.unexplained);
    let kinds: Vec<Kind> = found.located.iter().map(|at| at.kind).collect();
    assert_eq!(kinds, [Kind::BranchPoint, Kind::Flip, Kind::Flip]);
}

/// Where another regime begins a multiplier jumps over −1: nothing doubles there.
#[test]
fn a_jump_into_another_regime_and_back_is_no_flip() {
    let found = Along {
        multipliers: |r| match r {
            ..0.4 => [-0.5, 0.0, 0.0],
            ..0.6 => [-1.5, 0.0, 0.5],
            _ => [-1.5, 0.0, 0.0],
        },
        known: true,
    };
    let found = found.findings();
    assert!(found.unexplained.is_empty(), "{:?}", found.unexplained);
    let seen: Vec<(Kind, f64)> = found.located.iter().map(|at| (at.kind, at.r)).collect();
    assert_eq!(seen.len(), 2, "{seen:?}");
    for ((kind, r), expected) in seen.into_iter().zip([0.4, 0.6]) {
        assert_eq!(kind, Kind::VanishingSegment);
        assert!((r - expected).abs() < 1e-8, "{r}, not {expected}");
    }
}

#[test]
fn a_change_that_cannot_be_looked_into_is_reported() {
    let found = Along {
        multipliers: twice,
        known: false,
    };
    let found = found.findings();
    assert!(found.located.is_empty(), "{:?}", found.located);
    let [change] = found.unexplained.as_slice() else {
        panic!("{:?}", found.unexplained);
    };
    assert_eq!((change.between, change.unstable), ([0.0, 1.0], [0, 2]));
    assert_eq!(change.reason, "nobody knows what lies here");
}

/// A path on which each look finds a regime of its own.
struct Wavering(f64);

impl Wavering {
    fn point(&mut self, r: f64) -> Point {
        self.0 += 1.0;
        Point {
            r,
            multipliers: [0.0, 0.0, self.0],
        }
    }
}

impl Path for Wavering {
    type Point = Point;
    type Error = &'static str;

    fn at(&mut self, share: f64) -> Result<Point, &'static str> {
        Ok(self.point(share))
    }
}

#[test]
fn regimes_that_change_without_end_are_reported() {
    let mut path = Wavering(2.0);
    let ends = [0.0, 1.0].map(|r| path.point(r));
    let found = detect(&mut path, &[], [&ends[0], &ends[1]], 1e-9);
    let last = found.unexplained.last().map(|one| one.reason.as_str());
    assert_eq!(last, Some("the events change too often"));
}
