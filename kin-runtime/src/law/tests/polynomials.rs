//! Polynomials between two states.

use super::Random;
use crate::law::{Law as _, Polynomial, Rise, Shape};
use crate::motion::Motion;

/// The states at both ends come out, and there is no higher derivative than the conditions allow.
fn assert_states<const A: usize, const B: usize, const K: usize, const M: usize>(random: &mut Random) {
    assert_eq!(M, K + 1);
    for _ in 0..100 {
        let duration = random.size(0.1, 10.0);
        let mut unit = 1.0;
        let mut states = [[0.0; M]; 2];
        // so large that every derivative contributes to the motion alike
        for order in 0..M {
            for state in &mut states {
                state[order] = random.signed(1.0) * unit;
            }
            unit *= f64::from(u8::try_from(K - order.min(K - 1)).expect("it is small")) / duration;
        }
        let start = Motion::from(states[0]).truncate::<A>();
        let end = Motion::from(states[1]).truncate::<B>();
        let law: Polynomial<f64, K> = Polynomial::between(start, end, duration).expect("it is one");
        let (first, last) = (law.at::<M>(0.0), law.at::<M>(duration));
        let mut unit = 1.0;
        for order in 0..M {
            // a difference of the order n adds 2ⁿ coefficients, which are sums of as many conditions
            let rounding = 4_f64.powi(i32::try_from(order).expect("it is small")) * 4.0 * f64::EPSILON * unit;
            if order < A {
                assert!((first[order] - start[order]).abs() <= rounding, "{A} {B} start {order}");
            }
            if order < B {
                assert!((last[order] - end[order]).abs() <= rounding, "{A} {B} end {order}");
            }
            if order >= K {
                assert_eq!(first[order], 0.0);
            }
            unit *= f64::from(u8::try_from(K - order.min(K - 1)).expect("it is small")) / duration;
        }
        assert_eq!((first[0], last[0]), (start[0], end[0]));
    }
}

#[test]
fn any_states_come_out() {
    let mut random = Random(3);
    assert_states::<1, 1, 2, 3>(&mut random);
    assert_states::<2, 2, 4, 5>(&mut random);
    assert_states::<3, 3, 6, 7>(&mut random);
    assert_states::<4, 4, 8, 9>(&mut random);
    assert_states::<5, 5, 10, 11>(&mut random);
    assert_states::<6, 6, 12, 13>(&mut random);
    assert_states::<1, 4, 5, 6>(&mut random);
    assert_states::<5, 1, 6, 7>(&mut random);
    assert_states::<3, 2, 5, 6>(&mut random);
}

#[test]
fn between_rests_they_are_the_known_shapes() {
    let [rest, there] = [0.0, 1.0].map(Motion::<f64, 3>::constant);
    let law: Polynomial<f64, 6> = Polynomial::between(rest, there, 2.0).expect("it is one");
    let rise = Rise::new(Shape::Polynomial345, 0.0, 1.0, 2.0).expect("it is one");
    let power = [0.0, 0.0, 0.0, 10.0, -15.0, 6.0];
    for step in 0..=40 {
        let part = f64::from(step) / 40.0;
        let by_power: Motion<f64, 5> = Motion::polynomial(&power, part);
        for order in 0..5 {
            let scale = 0.5_f64.powi(i32::try_from(order).expect("it is small"));
            // 360 is the largest of the derivatives
            let rounding = 360.0 * 8.0 * f64::EPSILON;
            assert!((law.at::<5>(2.0 * part)[order] - scale * by_power[order]).abs() <= rounding);
            assert!((rise.at::<5>(2.0 * part)[order] - scale * by_power[order]).abs() <= rounding);
        }
    }
}
