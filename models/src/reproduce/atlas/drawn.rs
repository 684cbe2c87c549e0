//! Figures 3.15, 3.17 and 3.18 of the thesis as they are printed: stable and unstable orbits.

use stickslip::bifurcation::{Kind, Stability};
use stickslip::report::chart::{Chart, Drawn, placed};
use stickslip::report::{Axis, Inset, Panel};
use stickslip::study::{BranchRecord, OrbitRecord, Special};

use super::super::pieces::{Directed, UNKNOWN, directed, pieces};
use super::{Atlas, FAMILIES, Family, RANGE};

/// Points further apart than this are no curve where crossings come and go.
const APART: f64 = 0.1;

/// A quantity of orbits, and of special points.
pub(super) type Quantity = (fn(&OrbitRecord) -> f64, fn(&Special) -> f64);

/// Two panels in which each branch is a curve of this quantity.
pub(super) fn panels(atlases: [&Atlas; 2], label: &str, quantity: Quantity) -> [Panel; 2] {
    atlases.map(|atlas| curves(atlas, label, quantity))
}

fn panel(atlas: &Atlas, label: &str) -> Panel {
    let speed = Axis::new("*V*_{dr}").from(RANGE[0], RANGE[1]);
    Panel::new(speed, Axis::new(label)).titled(atlas.title())
}

/// All branches, each of one stability up to the next, and from where it leaves another; the table names the special
/// points.
fn curves(atlas: &Atlas, label: &str, (of, special): Quantity) -> Panel {
    let mut chart = Chart::new(panel(atlas, label));
    for (_, branch) in atlas.branches() {
        let mut drawn = Drawn::of((0, branch), |orbit| Some(of(orbit)), special);
        // So many markers would hide the branches.
        drawn.marks.iter_mut().for_each(|mark| mark.shown = false);
        chart.add(drawn);
    }
    chart.panel()
}

/// The Poincaré points, a panel for each family and system: as many curves for each branch as its orbits have points.
pub(super) fn points(atlases: [&Atlas; 2]) -> impl Iterator<Item = Panel> {
    FAMILIES.iter().flat_map(move |family| {
        atlases.map(|atlas| {
            let all = atlas.branches().filter(|(name, _)| *name == family.name);
            let strands = all.flat_map(|(_, branch)| strands(branch));
            let pieces: Vec<(bool, Vec<Directed>)> =
                strands.flat_map(|strand| pieces(&strand)).collect();
            // Stable pieces first: the legend names them first, too.
            let [stable, unstable] = [("stable", 0), ("unstable", 1)].map(|(label, series)| {
                let of = pieces
                    .iter()
                    .filter(move |(stable, _)| *stable == (series == 0));
                of.map(move |(_, points)| directed(label, series, points.clone()))
            });
            let panel = section_panel(atlas, family).curves(stable).curves(unstable);
            match CROWDED.iter().find(|(name, _)| *name == family.name) {
                Some((_, inset)) => panel.inset(inset.clone()),
                None => panel,
            }
        })
    })
}

/// Parts of families that only show what they are when they are enlarged.
const CROWDED: [(&str, Inset); 1] = [(
    "out of phase",
    Inset {
        x: [0.242, 0.298],
        y: [-0.34, 0.22],
        place: [0.56, 0.02, 0.99, 0.5],
    },
)];

fn section_panel(atlas: &Atlas, family: &Family) -> Panel {
    let speed = Axis::new("*V*_{dr}");
    let speed = match family.period {
        Some(_) => speed.from(RANGE[0], RANGE[1]),
        None => speed,
    };
    Panel::new(speed, Axis::new("*X*_{1} where *X*_{1}′ = 0")).titled(format!(
        "{}, {}",
        family.name,
        atlas.title()
    ))
}

/// What is drawn where a branch passes: the points of an orbit, and its stability if that is known.
type Row = (Option<bool>, Vec<Directed>);

type Strand = Vec<(bool, Directed)>;

/// The points of the orbits of a branch, each joined to what becomes of it on the next orbit.
fn strands(branch: &BranchRecord) -> Vec<Strand> {
    let (mut done, mut open): (Vec<Strand>, Vec<Strand>) = (Vec::new(), Vec::new());
    let rows = rows(branch);
    for (i, (stable, points)) in rows.iter().enumerate() {
        // A special point is drawn like what comes after it.
        let later = rows[i..].iter().find_map(|(stable, _)| *stable);
        let stable = stable.or(later).unwrap_or_default();
        let next = points.iter().map(|point| (stable, *point));
        let mut next: Vec<Option<(bool, Directed)>> = next.map(Some).collect();
        let mut going = Vec::new();
        let places = followed(&open, points);
        for (mut strand, place) in std::mem::take(&mut open).into_iter().zip(places) {
            match place.and_then(|place| next[place].take()) {
                Some(point) => {
                    strand.push(point);
                    going.push((place, strand));
                }
                None => done.push(strand),
            }
        }
        let new = next.into_iter().enumerate();
        let new = new.filter_map(|(place, point)| Some((Some(place), vec![point?])));
        going.extend(new);
        // In the order of time, as the points of the next orbit are.
        going.sort_by_key(|(place, _)| *place);
        open = going.into_iter().map(|(_, strand)| strand).collect();
    }
    done.extend(open);
    done
}

/// Which of these points each strand goes on with. The points of an orbit are in the order of time, and so they stay; only
/// which of them is the first may change.
fn followed(open: &[Strand], points: &[Directed]) -> Vec<Option<usize>> {
    let ends: Vec<[f64; 2]> = open
        .iter()
        .filter_map(|one| Some(one.last()?.1.0))
        .collect();
    let off = |end: &[f64; 2], place: usize| (points[place].0[1] - end[1]).abs();
    if ends.len() == points.len() {
        let count = points.len();
        let far = |turn: &usize| -> f64 {
            let pairs = ends.iter().enumerate();
            pairs
                .map(|(i, end)| off(end, (i + turn) % count).powi(2))
                .sum()
        };
        let turn = (0..count).min_by(|a, b| far(a).total_cmp(&far(b)));
        let turn = turn.unwrap_or_default();
        return (0..count).map(|i| Some((i + turn) % count)).collect();
    }
    // A crossing has come or gone where the motion touched the section.
    let mut free: Vec<usize> = (0..points.len()).collect();
    let mut next = |end: &[f64; 2]| {
        let near = (0..free.len()).min_by(|&i, &j| off(end, free[i]).total_cmp(&off(end, free[j])));
        let near = near.filter(|&i| off(end, free[i]) < APART)?;
        Some(free.swap_remove(near))
    };
    ends.iter().map(&mut next).collect()
}

/// The orbits of a branch with its special points between them, from where it leaves another.
fn rows(branch: &BranchRecord) -> Vec<Row> {
    let mut rows = Vec::new();
    for count in 0..=branch.points.len() {
        let special = branch.root.iter().chain(&branch.special);
        rows.extend(special.filter(|one| one.after == count).map(of_special));
        rows.extend(branch.points.get(count).map(of_orbit));
    }
    let closed = branch.ended.is_closed();
    rows.extend(branch.points.first().filter(|_| closed).map(of_orbit));
    rows
}

/// The first state where the orbit of a special point crosses its section, as often as it is gone around.
fn of_special(special: &Special) -> Row {
    let way = match special.kind {
        Kind::Fold => [0.0, 1.0],
        _ => UNKNOWN,
    };
    let points = special
        .section
        .iter()
        .map(|state| ([special.r, state[0]], way));
    let points: Vec<Directed> = points.collect();
    (None, points.repeat(special.turns))
}

/// The first state where an orbit crosses its section, with the direction in which each of these points moves.
fn of_orbit(orbit: &OrbitRecord) -> Row {
    let crossing = |i: usize| {
        let (at, direction) = placed(orbit, |orbit| Some(orbit.section.get(i)?[0]));
        (at, direction.unwrap_or(UNKNOWN))
    };
    let stable = orbit.floquet.stability == Stability::Stable;
    (
        Some(stable),
        (0..orbit.section.len()).map(crossing).collect(),
    )
}
