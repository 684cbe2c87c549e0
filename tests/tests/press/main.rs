//! Contacts that press and let go.

mod bilinear;
mod derivatives;
mod hopf;
mod models;
mod squeal;
