//! What a user is told: estimates, errors of smoothing, laws, and refusals.

mod coverage;
mod hostile;
mod laws;
mod trade;
