//! What a scene needs of its model.

mod brute;
mod models;
mod modes;
mod plain;
