//! The declaration language of `stickslip`: `model!` and `friction_law!`.
