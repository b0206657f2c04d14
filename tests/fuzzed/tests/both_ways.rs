//! The sample, compiled by rustc and declared from its text: both give the same numbers, to the last bit.
#![allow(dead_code, missing_docs, reason = "nobody has written them")]

use kin_agreement::assert_agreement;
use kin_declarations::Sample;

/// The comparison of a mechanism with its text.
type Found = fn(&str) -> [usize; 3];

/// How it is found.
type Find = fn() -> Found;

macro_rules! of {
    ($mechanism:ident) => {
        super::assert_agreement::<$mechanism>
    };
}

include!(concat!(env!("OUT_DIR"), "/sample.rs"));

#[test]
fn texts_agree_with_compiled_mechanisms() {
    let (mut finite, mut solved) = (0, 0);
    for (find, seed) in SAMPLE {
        let [own_finite, own_solved, _] = find()(&Sample::new(*seed).to_string());
        println!("{seed}: {own_finite} results are finite, {own_solved} positions are solved");
        finite += own_finite;
        solved += own_solved;
    }
    assert!(
        finite >= 1000 * SAMPLE.len() && solved >= 100 * SAMPLE.len(),
        "{finite} and {solved}"
    );
}
