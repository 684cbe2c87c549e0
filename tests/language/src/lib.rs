//! Holds the macros to what they say of mistakes: see `tests/`.
