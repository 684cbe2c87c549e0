//! Contacts that press and let go.

mod audit;
mod bilinear;
mod derivatives;
mod hopf;
mod impact;
mod models;
mod rest;
mod squeal;
