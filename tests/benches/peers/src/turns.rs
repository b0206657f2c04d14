//! This program as a contender: it takes turns with `solve`, as `turns.c` does with a kernel.

use core::hint::black_box;
use std::fs;
use std::io::BufRead as _;

use kin_core::Prepared;
use kin_tests::mechanisms::cases::ThroughSnap;

use crate::linkages::{Course, Visitor};
use crate::race::{solve_each, turn};

/// Solves the poses of a course, writes what it finds to a file, and solves them again for each line of its input.
pub(crate) struct Turns {
    pub(crate) course: String,
    /// Whether the mechanism is prepared.
    pub(crate) is_prepared: bool,
    pub(crate) file: String,
}

impl Visitor for Turns {
    fn visit<M: ThroughSnap>(&mut self, course: Course<M>) {
        if course.name() != self.course {
            return;
        }
        let Course { mechanism, wanted, .. } = course;
        let numbers = wanted.iter().flat_map(|own| own.results(mechanism));
        let bytes: Vec<u8> = numbers.flat_map(f64::to_le_bytes).collect();
        fs::write(&self.file, bytes).expect("cargo's folder can be written");
        println!("ready");
        let prepared = Prepared::of(mechanism);
        for _ in std::io::stdin().lock().lines() {
            let time = if self.is_prepared {
                turn(|| solve_each(&wanted, |own| own.solve_prepared(black_box(&prepared))))
            } else {
                turn(|| solve_each(&wanted, |own| own.solve(black_box(&mechanism))))
            };
            println!("{time}");
        }
    }
}
