//! Every test mechanism at the ends of its range: found by bisection to the last bit, then looked at from both sides.

use kin_core::prelude::*;
use kin_tests::mechanisms::cases::{self, Case, Visitor};
use kin_tests::oracles::Worst;
use kin_tests::random::Random;

/// Where a mechanism closes and where it does not, a unit in the last place apart.
struct Limit<M: Mechanism<Scalar = f64>> {
    assembly: M::Assembly,
    inside: f64,
    outside: f64,
}

/// The inputs with the first one at a given value.
fn with_first<M: Mechanism<Scalar = f64>>(inputs: M::Inputs<Motion<f64, 5>>, value: f64) -> M::Inputs<Motion<f64, 5>> {
    let mut inputs = inputs;
    let mut derivatives = inputs.as_ref()[0].derivatives();
    derivatives[0] = value;
    inputs.as_mut()[0] = Motion::new(derivatives);
    inputs
}

fn limits<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: M::Inputs<Motion<f64, 5>>,
    (low, high): (f64, f64),
) -> Vec<Limit<M>> {
    let closes = |value: f64, assembly| {
        let values = with_first::<M>(inputs, value);
        let values = M::Inputs::from_fn(|index| values.as_ref()[index].value());
        mechanism.solve_position(values, assembly).is_ok()
    };
    // half as much again at either end
    let at = |step: i32| low + (high - low) * (f64::from(step) / 60.0 - 0.5);
    let mut limits = Vec::new();
    for assembly in M::assemblies() {
        for step in 0..120 {
            let (mut inside, mut outside) = match (closes(at(step), assembly), closes(at(step + 1), assembly)) {
                (true, false) => (at(step), at(step + 1)),
                (false, true) => (at(step + 1), at(step)),
                _ => continue,
            };
            loop {
                let middle = inside + (outside - inside) / 2.0;
                if middle == inside || middle == outside {
                    break;
                }
                if closes(middle, assembly) {
                    inside = middle;
                } else {
                    outside = middle;
                }
            }
            limits.push(Limit {
                assembly,
                inside,
                outside,
            });
        }
    }
    limits
}

/// Poses ever nearer to each limit against the oracles, and failures ever nearer to it from outside.
#[derive(Default)]
struct Approach {
    limits: usize,
    without_limits: Vec<&'static str>,
}

impl Visitor for Approach {
    fn visit<M: Mechanism<Scalar = f64>>(&mut self, case: Case) {
        let name = M::DESCRIPTION.name;
        let mut random = Random::new(91);
        let mut worst = Worst::default();
        let mechanism: M = case.mechanism();
        let mut count = 0;
        for fraction in [0.3, 0.8] {
            let inputs = case.inputs::<M>(fraction, &mut random);
            for limit in limits(&mechanism, inputs, case.inputs[0]) {
                count += 1;
                let size = limit.inside.abs().max(1.0);
                let way = (limit.inside - limit.outside).signum() * size;
                let mut last = f64::NEG_INFINITY;
                for exponent in 3..=15 {
                    let step = way * 10.0_f64.powi(-exponent);
                    worst.check(&mechanism, with_first::<M>(inputs, limit.inside + step), limit.assembly);
                    let values = with_first::<M>(inputs, limit.outside - step);
                    let values = M::Inputs::from_fn(|index| values.as_ref()[index].value());
                    let error = mechanism
                        .solve_position(values, limit.assembly)
                        .map(drop)
                        .expect_err("this is outside of the range");
                    assert!(
                        matches!(
                            error.failure,
                            Failure::OutOfReach { .. }
                                | Failure::Singular { .. }
                                | Failure::OutsideDomain { .. }
                                | Failure::OutOfRange { .. }
                                | Failure::Ambiguous { .. }
                        ),
                        "{name}: {error}"
                    );
                    if let Some(margin) = error.margin() {
                        // towards the limit it shrinks, to rounding
                        assert!(
                            margin <= 0.0 && margin >= last - 1e-12 * size * 100.0,
                            "{name}: {margin} after {last}"
                        );
                        last = margin;
                    }
                }
            }
        }
        self.limits += count;
        if count == 0 {
            self.without_limits.push(name);
        } else {
            println!(
                "{name:28} {count:2} limits, {:4} poses, differentiation {:8.3?}, closure {:8.3?}",
                worst.poses, worst.differentiation, worst.closure
            );
            worst.assert_allowed(name);
        }
    }
}

#[test]
fn from_both_sides() {
    let mut approach = Approach::default();
    cases::all(&mut approach);
    println!("no limits: {:?}", approach.without_limits);
    assert!(approach.limits > 200, "{}", approach.limits);
}
