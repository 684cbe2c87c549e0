//! What the macros make of a declaration: data, values and derivatives.

mod awkward_names;
mod by_hand;
mod chains;
mod declared;
mod declared_data;
mod derivatives;
mod hand_written;
mod slopes;
mod structure;
mod tangents;
