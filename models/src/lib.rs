//! The physics: reference systems, the library of friction laws, closed-form solutions.
