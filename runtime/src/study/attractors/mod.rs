//! All motions on which a system settles, found from starts spread over a region of its states.
//!
//! A first few starts are looked at closely: what they settle on is recognised by its returns and polished to an orbit, an
//! equilibrium or a set of sticking states. Every other start is followed until its future is known: it lets go of a
//! contact where one of the first did, or on a line between two that went on alike, enters a region around an equilibrium in
//! which a Lyapunov function falls, comes nearer to a known orbit for as many laps as that takes to attract, or keeps to
//! where a chaotic motion goes. Only what remains is looked at closely, too. So each start depends on the question alone,
//! and on no other start beyond those first ones.

mod alike;
mod areas;
mod basin;
mod closely;
mod cloud;
mod edge;
mod followed;
mod following;
mod further;
mod future;
mod ground;
mod memo;
mod passes;
mod pursuit;
mod record;
mod returns;
mod running;
mod scouted;
mod setting;
mod statistics;
mod survey;
mod track;
mod trap;

pub use followed::{Followed, FollowedRecord, Spot};
pub(in crate::study) use ground::closely;
pub use record::{Attractor, AttractorsRecord, Class, Edge, Fate, Found, Survey};
pub use setting::{Region, Sampling, Side};
