//! What a user is told: estimates, errors of smoothing, laws, and refusals.

mod braced;
mod certificates;
mod coverage;
mod crawling;
mod ferried;
mod gripped;
mod hostile;
mod lattice;
mod laws;
mod neutral;
mod news;
mod periods;
mod proofs;
mod resting;
mod running;
mod saturated;
mod sizes;
mod trade;
mod turning;
