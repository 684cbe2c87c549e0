//! All motions without a seed: shares of published systems, boundaries in closed form, and nothing that depends on how
//! the work is shared.

mod ends;
mod further;
mod isolas;
mod models;
mod settling;
mod shares;
mod sharing;
mod transport;
mod windings;
