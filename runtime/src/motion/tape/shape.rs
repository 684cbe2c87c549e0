//! Whether what a tape holds has the shape of what was asked: nothing that was read is trusted with an index.

use nalgebra::{DMatrix, DVector};

use crate::motion::{Derivatives, Passage, Place};

/// Something that belongs to a motion.
pub(super) trait Shaped {
    /// Whether it can belong to a motion through a place like this: as many states and contacts, and finite.
    fn is_like(&self, place: &Place) -> bool;
}

impl<A: Shaped, B: Shaped> Shaped for (A, B) {
    fn is_like(&self, place: &Place) -> bool {
        self.0.is_like(place) && self.1.is_like(place)
    }
}

impl<T: Shaped> Shaped for Option<T> {
    fn is_like(&self, place: &Place) -> bool {
        self.as_ref().is_none_or(|one| one.is_like(place))
    }
}

impl<T: Shaped> Shaped for Vec<T> {
    fn is_like(&self, place: &Place) -> bool {
        self.iter().all(|one| one.is_like(place))
    }
}

/// Values of all states.
impl Shaped for [f64] {
    fn is_like(&self, place: &Place) -> bool {
        self.len() == place.state.len() && self.iter().all(|value| value.is_finite())
    }
}

impl Shaped for DVector<f64> {
    fn is_like(&self, place: &Place) -> bool {
        self.as_slice().is_like(place)
    }
}

impl Shaped for DMatrix<f64> {
    fn is_like(&self, place: &Place) -> bool {
        let order = place.state.len();
        self.shape() == (order, order) && self.iter().all(|value| value.is_finite())
    }
}

impl Shaped for Place {
    fn is_like(&self, place: &Place) -> bool {
        self.state.is_like(place) && self.modes.len() == place.modes.len()
    }
}

impl Shaped for Derivatives {
    fn is_like(&self, place: &Place) -> bool {
        let factors = self.factors.iter();
        self.state.is_like(place)
            && self.design.is_like(place)
            && self.time.is_like(place)
            && factors.clone().all(|factor| factor.state.is_like(place))
            && factors.clone().all(|factor| factor.growth.is_like(place))
    }
}

impl Shaped for Passage {
    fn is_like(&self, place: &Place) -> bool {
        let (order, contacts) = (place.state.len(), place.modes.len());
        let extrema = self.extrema.iter();
        let events = self.events.iter();
        let segments = self.segments.iter();
        let calm = &self.calm;
        self.end.is_like(place)
            && self.derivatives.is_like(place)
            && extrema
                .map(|e| (e.index, &e.state))
                .all(|(j, state)| j < order && state.is_like(place))
            && events
                .map(|e| (e.contact, &e.state))
                .all(|(i, state)| i < contacts && state.is_like(place))
            && segments
                .map(|segment| &segment.modes)
                .all(|modes| modes.len() == contacts)
            && self.path.iter().all(|sample| sample.state.is_like(place))
            && self.nodes.iter().all(|node| node.state.is_like(place))
            && calm.place.is_like(place)
            && calm.low.is_like(place)
            && calm.high.is_like(place)
    }
}
