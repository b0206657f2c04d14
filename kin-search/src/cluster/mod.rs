//! The same queries on several machines.
//!
//! A [`Scheduler`] distributes tasks, [`Executor`]s run them, and a [`Client`] sends queries: three kinds of processes,
//! which run the same program and hold the same functions.

mod address;
mod admission;
mod assigned;
mod client;
mod codec;
mod cores;
mod cut;
mod executor;
mod fault;
mod identity;
mod ids;
mod job;
mod options;
mod parts;
mod progress;
mod scheduler;
mod stop;
mod tables;

pub use address::{Endpoint, Listen};
pub use client::{Client, Connection};
pub use executor::Executor;
pub use fault::Fault;
pub use identity::Identity;
pub use scheduler::Scheduler;
