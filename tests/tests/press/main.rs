//! Contacts that press and let go.

mod audit;
mod bilinear;
mod buffer;
mod by_hand;
mod copies;
mod corner;
mod derivatives;
mod feeder;
mod follower;
mod graze;
mod ground;
mod hopf;
mod impact;
mod jumps;
mod models;
mod narrowing;
mod penalty;
mod pinned;
mod rates;
mod rest;
mod rocking;
mod squeal;
mod unfelt;
mod valve;
mod volumes;
mod walls;
