use super::*;
use crate::continuation::Linearisation;
use nalgebra::DMatrix;

/// z² + r² = 1: two folds.
#[derive(Clone)]
struct Circle;

impl ZeroProblem for Circle {
    type Error = std::fmt::Error;
    type Extra = ();

    fn evaluate(&mut self, z: &DVector<f64>, r: f64) -> Result<Linearisation<()>, std::fmt::Error> {
        Ok(Linearisation {
            residual: DVector::from_element(1, z[0] * z[0] + r * r - 1.0),
            jacobian: DMatrix::from_element(1, 1, 2.0 * z[0]),
            design: DVector::from_element(1, 2.0 * r),
            extra: (),
        })
    }

    fn scale(&self) -> DVector<f64> {
        DVector::from_element(1, 1.0)
    }
}

#[test]
fn goes_through_a_fold_and_comes_back() {
    let start = DVector::from_element(1, 1.0);
    let (mut branch, first) = Branch::start(Circle, start, Settings::new(0.0, 2.0, 1e-12)).unwrap();
    let points: Vec<_> = std::iter::once(first).chain(branch.by_ref()).collect();
    assert_eq!(branch.stop(), Some(&Stop::ReachedStart));
    let largest = points.iter().map(|point| point.r).fold(0.0, f64::max);
    assert!((0.9..=1.0 + 1e-12).contains(&largest), "{largest}");
    assert!(points.last().unwrap().z[0] < -0.9);
    assert!(
        points
            .iter()
            .all(|p| (p.z[0].hypot(p.r) - 1.0).abs() < 1e-10)
    );
    assert!(
        points
            .windows(2)
            .any(|pair| pair[0].tangent[1] * pair[1].tangent[1] < 0.0)
    );
}

#[test]
fn a_fold_within_the_first_step_is_not_stepped_over() {
    // 0.0014 to the fold, and as far back to where it began: first steps of 0.02 and of half the circle.
    let from: f64 = 1.0 - 1e-6;
    let start = DVector::from_element(1, (1.0 - from * from).sqrt());
    for first_step in [0.02, 0.5] {
        let settings = Settings {
            first_step,
            ..Settings::new(from, 2.0, 1e-12)
        };
        let (mut branch, _) = Branch::start(Circle, start.clone(), settings).unwrap();
        let points: Vec<_> = branch.by_ref().collect();
        assert_eq!(branch.stop(), Some(&Stop::ReachedStart));
        assert!(points.iter().all(|point| point.r >= from), "{points:?}");
        let last = points.last().unwrap();
        assert!(last.r == from && (last.z[0] + start[0]).abs() < 1e-10);
    }
}

#[test]
fn a_branch_that_begins_outside_its_range_comes_back_to_it() {
    // Whether it sets off away from the range or towards it.
    for to in [0.9, 0.75] {
        let start = DVector::from_element(1, 0.6);
        let (mut branch, first) =
            Branch::start(Circle, start, Settings::new(0.8, to, 1e-12)).unwrap();
        assert_eq!(first.r, 0.8);
        branch.settings = Settings::new(0.0, 0.7, 1e-12);
        let last = branch.by_ref().last().unwrap();
        assert_eq!(last.r, 0.7);
        assert!((last.z[0] - (1.0_f64 - 0.49).sqrt()).abs() < 1e-12);
        assert_eq!(branch.stop(), Some(&Stop::ReachedEnd));
    }
}

#[test]
fn ends_exactly_at_the_end() {
    let start = DVector::from_element(1, 1.0);
    let (mut branch, _) = Branch::start(Circle, start, Settings::new(0.0, 0.7, 1e-12)).unwrap();
    let last = branch.by_ref().last().unwrap();
    assert_eq!(last.r, 0.7);
    assert!((last.z[0] - (1.0_f64 - 0.49).sqrt()).abs() < 1e-12);
    assert_eq!(branch.stop(), Some(&Stop::ReachedEnd));
}

#[test]
fn a_point_between_two_lies_on_the_branch() {
    let start = DVector::from_element(1, 1.0);
    let (mut branch, _) = Branch::start(Circle, start, Settings::new(0.0, 2.0, 1e-12)).unwrap();
    assert!(branch.link().is_none());
    let last = branch.by_ref().take(4).last().unwrap();
    let mut link = branch.link().unwrap().clone();
    let point = link.between(0.3).unwrap();
    assert!((point.z[0].hypot(point.r) - 1.0).abs() < 1e-12);
    assert!(point.r < last.r && point.tangent[1] > last.tangent[1]);
}
