//! A structure as data: what its file says of its modes, and which states and parameters those are.

/// A `structure` line as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Structure {
    /// Name as declared.
    pub name: &'static str,
    /// Its named points.
    pub points: &'static [StructurePoint],
    /// All modes of its file in their order, each of modal mass 1; those that the model keeps come first.
    pub modes: &'static [StructureMode],
    /// How many the model keeps.
    pub kept: usize,
}

/// A named point of a structure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StructurePoint {
    /// Its name.
    pub name: &'static str,
    /// Whether its displacement is a rotation.
    pub turns: bool,
    /// What it gives way under its own unit load, all modes of the file apart.
    pub residual: f64,
}

/// A mode of a structure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StructureMode {
    /// The angular frequency of the undamped mode; 0 where the structure moves as a whole.
    pub frequency: f64,
    /// Its displacement at each point.
    pub shape: &'static [f64],
    /// Place of its amplitude among the states, if it is kept.
    pub amplitude: Option<usize>,
    /// Place of the rate of that.
    pub rate: Option<usize>,
    /// Place of the parameter that leaves it out where it is 0, if it is kept and elastic.
    pub share: Option<usize>,
}

impl Structure {
    /// What each point gives way under its own unit load by modes from this one on and by what no mode has.
    #[must_use]
    pub fn flexibility_beyond(&self, kept: usize) -> Vec<f64> {
        let elastic = self.modes.iter().skip(kept);
        let elastic: Vec<&StructureMode> = elastic.filter(|mode| mode.frequency > 0.0).collect();
        let give = |j: usize| {
            let modes = elastic.iter();
            modes.map(move |mode| (mode.shape[j] / mode.frequency).powi(2))
        };
        let points = self.points.iter().enumerate();
        points
            .map(|(j, point)| point.residual + give(j).sum::<f64>())
            .collect()
    }

    /// The largest share of the flexibility of a point that lies in modes from this one on and in what no mode has.
    #[must_use]
    pub fn share_beyond(&self, kept: usize) -> f64 {
        let pairs = self
            .flexibility_beyond(kept)
            .into_iter()
            .zip(self.flexibility_beyond(0));
        let shares = pairs
            .filter(|(_, whole)| *whole > 0.0)
            .map(|(beyond, whole)| beyond / whole);
        shares.fold(0.0, f64::max)
    }

    /// The displacement of a point in a state, or the rate of that.
    #[must_use]
    pub fn at(&self, point: usize, state: &[f64], rate: bool) -> f64 {
        let kept = self.modes.iter().filter_map(|mode| {
            let place = if rate { mode.rate } else { mode.amplitude }?;
            Some(mode.shape[point] * state.get(place)?)
        });
        kept.sum()
    }
}
