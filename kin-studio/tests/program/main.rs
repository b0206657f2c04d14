//! The program, as a person types it.

mod codes;
mod commands;
mod files;
mod imported;
mod mistakes;
mod serving;
mod typed;
