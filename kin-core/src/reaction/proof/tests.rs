//! Proved bounds beside forces in single poses, over inputs and corners of tolerances.

use std::f64::consts::TAU;
use std::println;
use std::vec::Vec;

use super::{ForceProof, ForceVerdict, ProofError, UndecidedReason};
use crate::any::{AssemblyChoice, PositionChoice};
use crate::linkage::AnyLinkage;
use crate::load::NamedLoads;
use crate::motion::Motion;
use crate::reaction::tests::{ENGINE, FOUR_BAR, heavy};
use crate::reaction::{NamedReactions, ReactionPart};

const SPEED: f64 = 12.0;

#[test]
fn first() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let loads = heavy(&linkage);
    let reactions = linkage.reactions(&loads).unwrap();
    let turn = linkage.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[TAU], 721).speed(SPEED);
    for name in ["knee", "pin", "pivot", "base"] {
        let sampled = turn.of_reaction(&reactions, name, ReactionPart::Force, 0).peak().unwrap();
        for part in [1e-2, 1e-4, 1e-6, 1e-8] {
            let begun = std::time::Instant::now();
            let found = turn.proof(&reactions).of(name, ReactionPart::Force).unwrap().peak(part);
            println!("{name} {part} {} {} {found:?} {:?}", sampled.value, sampled.at, begun.elapsed());
        }
        for part in [1e-1, 1e-2, 1e-3, 1e-4] {
            let begun = std::time::Instant::now();
            let found = turn
                .proof(&reactions)
                .tolerance("r2", 1e-3).unwrap()
                .tolerance("r3", 1e-3).unwrap()
                .tolerance("r4", 1e-3).unwrap()
                .of(name, ReactionPart::Force).unwrap().peak(part);
            println!("tolerances {name} {part} {found:?} {:?}", begun.elapsed());
        }
    }
}
