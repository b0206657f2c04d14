//! The program of the library's mechanisms.

use std::process::ExitCode;

use kin_core::prelude::*;
use kin_studio::library::{self, Visitor};
use kin_studio::program::{self, Entry};

/// All mechanisms of the library.
struct Shelf(Vec<Entry>);

impl Visitor for Shelf {
    fn visit<M: Mechanism<Scalar = f64> + 'static>(
        &mut self,
        mechanism: &M,
        inputs: M::Inputs<f64>,
        assembly: M::Assembly,
    ) {
        self.0.push(Entry::new(mechanism, inputs, assembly));
    }
}

fn main() -> ExitCode {
    let mut shelf = Shelf(Vec::new());
    if let Err(error) = library::visit(&mut shelf) {
        eprintln!("error: the library's own dimensions do not close: {error}");
        return ExitCode::from(1);
    }
    program::library(&shelf.0)
}
