//! Symmetries of order two of a system: changes of sign, exchanges of states, half a turn of a drive or of what runs on.

use nalgebra::DMatrix;

use super::turns::Turns;

/// Systems of more states are asked for changes of sign only: exchanges of states become too many.
const EXCHANGED: usize = 6;
/// Systems of more states are asked for the change of all signs only.
const SIGNED: usize = 12;

/// A symmetry of order two: states change signs and places in pairs, and what comes round moves by half a turn.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::shooting) struct Symmetry {
    /// Which state each one becomes.
    place: Vec<usize>,
    /// And with which sign.
    sign: Vec<f64>,
    /// By how much what comes round moves.
    moved: Vec<f64>,
}

impl Symmetry {
    /// What it makes of a direction.
    pub(super) fn linear(&self, y: &[f64]) -> Vec<f64> {
        let pairs = self.sign.iter().zip(&self.place);
        pairs.map(|(sign, place)| sign * y[*place]).collect()
    }

    /// What it makes of a state.
    pub(in crate::shooting) fn of(&self, y: &[f64]) -> Vec<f64> {
        let image = self.linear(y).into_iter().zip(&self.moved);
        image.map(|(y, moved)| y + moved).collect()
    }

    /// What it makes of directions.
    pub(in crate::shooting) fn matrix(&self) -> DMatrix<f64> {
        let order = self.sign.len();
        DMatrix::from_fn(order, order, |i, j| {
            if j == self.place[i] {
                self.sign[i]
            } else {
                0.0
            }
        })
    }

    /// What it keeps of states, (1 + S)/2, or changes, (1 − S)/2.
    pub(super) fn part(&self, sign: f64) -> DMatrix<f64> {
        let order = self.sign.len();
        (DMatrix::identity(order, order) + self.matrix() * sign) * 0.5
    }

    /// The state nearest to this one that it leaves as it is.
    pub(super) fn kept(&self, y: &[f64]) -> Vec<f64> {
        let image = self.linear(y);
        y.iter()
            .zip(image)
            .map(|(a, b)| f64::midpoint(*a, b))
            .collect()
    }

    /// All of them but the one that changes nothing.
    pub(super) fn all(turns: &Turns) -> Vec<Self> {
        let order = turns.order();
        let mut all = vec![Self::signed(vec![0.0; order])];
        if order > SIGNED {
            let sign = |i| if turns.has(i) { 1.0 } else { -1.0 };
            all[0].sign = (0..order).map(sign).collect();
        } else {
            for i in 0..order {
                all = all.iter().flat_map(|one| one.extended(i, turns)).collect();
            }
        }
        let nothing = Self::signed(vec![1.0; order]);
        let halves = turns.halves();
        let moved = all.iter().flat_map(|one| {
            halves.iter().map(|moved| Self {
                moved: moved.clone(),
                ..one.clone()
            })
        });
        moved.filter(|one| *one != nothing).collect()
    }

    /// Changes these signs and no places.
    fn signed(sign: Vec<f64>) -> Self {
        Self {
            place: (0..sign.len()).collect(),
            moved: vec![0.0; sign.len()],
            sign,
        }
    }

    /// The ways in which state i can take part, if those before it are settled.
    fn extended(&self, i: usize, turns: &Turns) -> Vec<Self> {
        if self.sign[i] != 0.0 {
            return vec![self.clone()];
        }
        let partners = if turns.has(i) || self.sign.len() > EXCHANGED {
            i..i + 1
        } else {
            i..self.sign.len()
        };
        let signs: &[f64] = if turns.has(i) { &[1.0] } else { &[1.0, -1.0] };
        let pairs = partners.flat_map(|j| signs.iter().map(move |sign| (j, *sign)));
        pairs
            .filter(|(j, _)| self.sign[*j] == 0.0 && (*j == i || !turns.has(*j)))
            .map(|(j, sign)| {
                let mut one = self.clone();
                (one.place[i], one.place[j]) = (j, i);
                (one.sign[i], one.sign[j]) = (sign, sign);
                one
            })
            .collect()
    }
}
