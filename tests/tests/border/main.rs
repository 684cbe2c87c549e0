//! Where the events of orbits change: borders, what lies beyond them, and their curves.

mod between;
mod borders;
mod carriage;
mod carried;
mod corner;
mod curves;
mod ends;
mod grazing;
mod held;
mod hit;
mod kinked;
mod lets_go;
mod starts;
mod still;
mod turned;
mod zero;
