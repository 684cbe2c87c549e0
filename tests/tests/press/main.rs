//! Contacts that press and let go.

mod audit;
mod bilinear;
mod derivatives;
mod graze;
mod hopf;
mod impact;
mod models;
mod rest;
mod squeal;
