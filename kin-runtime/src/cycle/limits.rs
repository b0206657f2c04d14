//! All limits of a mechanism over a line of inputs.

use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::TAU;

use num_traits::Float;

use super::Incomplete;
use super::closure::{Closure, ClosureOnLine};
use super::line::InputLine;
use super::polynomial::{ClosureQuantity, Quantities};
use super::singular::{Singular, singular_positions};
use super::sought::{CoupledBlocks, SoughtMechanism};
use crate::quantity::Dimension;
use crate::quantity::NameKind;

/// An input at which the Jacobian of a block is singular.
#[derive(Clone, Debug)]
pub(super) struct SingularPoint {
    pub(super) s: f64,
    /// The unknowns on which the block depends.
    pub(super) unknowns: Vec<Singular>,
    /// Whether the closure and det J = 0 have a multiple solution here, as at a change point.
    pub(super) is_multiple: bool,
}

/// The closure along a line, as polynomials.
struct AlongLine {
    closure: Closure,
    /// The variable of the closure is `from + rate s` at a coordinate s of the line.
    from: f64,
    rate: f64,
}

impl AlongLine {
    /// The closure, if it is algebraic along the line.
    fn new(mechanism: &SoughtMechanism<'_>, functions: &dyn CoupledBlocks, line: &InputLine) -> Option<Self> {
        let mut moving = (0..line.direction.len()).filter(|input| line.direction[*input] != 0.0);
        // A length that moves alone stands for the coordinate on the line, so that its products with cosines are no
        // sums.
        let alone = match (moving.next(), moving.next()) {
            (Some(input), None) if !line.is_angle => Some(input),
            _ => None,
        };
        let (from, rate) = alone.map_or((0.0, 1.0), |input| (line.from[input], line.direction[input]));
        let (mut start, mut direction) = (line.from.to_vec(), line.direction.to_vec());
        if let Some(input) = alone {
            (start[input], direction[input]) = (0.0, 1.0);
        }
        let kind = |is_angle: bool| {
            if is_angle {
                ClosureQuantity::Angle
            } else {
                ClosureQuantity::Plain
            }
        };
        let unknowns = mechanism.unknowns().iter();
        let kinds = unknowns.map(|unknown| kind(unknown.dimension == Dimension::Angle));
        let quantities = Quantities::new(core::iter::once(kind(line.is_angle)).chain(kinds).collect());
        let mut closure = None;
        functions.closure_terms(&mechanism.parameters, &mut |terms, coefficients| {
            let on_line = ClosureOnLine {
                terms,
                coefficients,
                from: &start,
                direction: &direction,
            };
            closure = Closure::new(&quantities, on_line);
        });
        closure.map(|closure| Self { closure, from, rate })
    }

    /// The coordinate on the line for a value of the closure's variable.
    fn coordinate(&self, input: f64) -> f64 {
        (input - self.from) / self.rate
    }
}

/// All limits over the range of a line, in ascending order, whether or not the blocks close that are solved later.
///
/// # Errors
/// Says if the closure is not algebraic, if an unknown has a declared range, or may grow beyond all bounds, if
/// there are too many paths, or if one of them was lost.
pub(super) fn limits(
    mechanism: &SoughtMechanism<'_>,
    functions: &dyn CoupledBlocks,
    line: &InputLine,
) -> Result<Vec<SingularPoint>, Incomplete> {
    let description = mechanism.description();
    if let Some(unknown) = description.unknowns.iter().position(|unknown| unknown.has_range) {
        let unknown = mechanism.functions.name(NameKind::Unknown, unknown);
        return Err(Incomplete::DeclaredRange { unknown });
    }
    let along = AlongLine::new(mechanism, functions, line).ok_or(Incomplete::NotAlgebraic)?;
    let found = singular_positions(mechanism, &along.closure)?;
    let period = line.is_angle.then_some(TAU);
    let mut all: Vec<SingularPoint> = found
        .iter()
        .flat_map(|position| {
            let coordinates = shifted(along.coordinate(position.input), period, [line.low, line.high]);
            coordinates.into_iter().map(|s| SingularPoint {
                s,
                unknowns: position.unknowns.clone(),
                is_multiple: position.is_multiple,
            })
        })
        .collect();
    all.sort_by(|one, other| one.s.total_cmp(&other.s));
    Ok(all)
}

/// The coordinates of a range that differ from one by whole periods.
fn shifted(s: f64, period: Option<f64>, [low, high]: [f64; 2]) -> Vec<f64> {
    let Some(period) = period else {
        return if s >= low && s <= high { vec![s] } else { Vec::new() };
    };
    let first = s + period * Float::ceil((low - s) / period);
    core::iter::successors(Some(first), |shifted| Some(shifted + period))
        .take_while(|shifted| *shifted <= high)
        .collect()
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::super::{Branch, CycleData, FullCycle};
    use super::{AlongLine, ClosureQuantity, Incomplete, InputLine, SoughtMechanism};
    use crate::any::Of;
    use crate::curve::LimitKind;
    use crate::geometry::Plane;
    use crate::library::*;
    use crate::mechanism::Mechanism;
    use crate::number::{NumberRow, Row};

    crate::mechanism! {
        /// A four-bar linkage whose rocker moves a class III triad.
        struct RockerAndTriad {
            pub ground: Length, pub crank: Length, pub coupler: Length, pub rocker: Length, pub arm: Length,
            pub a: Length, pub b: Length, pub c: Length, pub p: Length, pub q: Length, pub delta: Angle,
            pub pivot_b: Point, pub pivot_c: Point,
        }
        input theta: Angle;
        unknown theta3: Angle, theta4: Angle, alpha: Angle, beta: Angle, gamma: Angle, phi: Angle;
        crank * cis(theta) + coupler * cis(theta3) == ground + rocker * cis(theta4);
        arm * cis(theta4) + a * cis(alpha) + p * cis(phi) == pivot_b + b * cis(beta);
        arm * cis(theta4) + a * cis(alpha) + q * cis(phi + delta) == pivot_c + c * cis(gamma);
    }

    crate::mechanism! {
        /// A cylinder, and a link on two legs.
        struct CylinderAndLegs {
            pub b: Length, pub c: Length, pub p: Length, pub q: Length, pub delta: Angle,
            pub pivot_b: Point, pub pivot_c: Point,
        }
        input s: Length;
        unknown sigma: Angle, beta: Angle, gamma: Angle, phi: Angle;
        s * cis(sigma) + p * cis(phi) == pivot_b + b * cis(beta);
        s * cis(sigma) + q * cis(phi + delta) == pivot_c + c * cis(gamma);
    }

    crate::mechanism! {
        /// A motor between two links, and a link on two legs.
        struct MotorAndLegs {
            pub crank: Length, pub a: Length, pub b: Length, pub c: Length, pub p: Length, pub q: Length,
            pub delta: Angle, pub pivot_b: Point, pub pivot_c: Point,
        }
        input theta: Angle;
        unknown psi: Angle, beta: Angle, gamma: Angle, phi: Angle;
        crank * cis(psi) + a * cis(psi + theta) + p * cis(phi) == pivot_b + b * cis(beta);
        crank * cis(psi) + a * cis(psi + theta) + q * cis(phi + delta) == pivot_c + c * cis(gamma);
    }

    crate::mechanism! {
        /// Products of a length and two sines.
        struct TurnedGuide {
            pub crank: Length, pub a: Length, pub c: Length, pub p: Length, pub delta: Angle,
            pub pivot_b: Point, pub pivot_c: Point,
        }
        input theta: Angle;
        unknown psi: Angle, beta: Angle, slide: Length, phi: Angle;
        crank * cis(theta) + a * cis(psi) + p * cis(phi) == pivot_b + slide * cis(beta + phi);
        crank * cis(theta) + a * cis(psi) + 2 * p * cis(phi + delta) == pivot_c + c * cis(beta);
    }

    crate::mechanism! {
        /// Legs that a gear of any ratio drives, so that the closure is not algebraic.
        struct GearAndLegs {
            pub a: Length, pub b: Length, pub c: Length, pub p: Length, pub q: Length, pub ratio: Scalar,
            pub pivot_b: Point, pub pivot_c: Point,
        }
        input theta: Angle;
        unknown alpha: Angle, beta: Angle, gamma: Angle, phi: Angle;
        a * cis(ratio * theta) + p * cis(phi) + c * cis(alpha) == pivot_b + b * cis(beta);
        a * cis(theta) + q * cis(phi) + c * cis(alpha) == pivot_c + c * cis(gamma);
    }

    const CYLINDER: CylinderAndLegs = CylinderAndLegs {
        b: 2.2,
        c: 2.4,
        p: 1.0,
        q: 1.2,
        delta: 0.8,
        pivot_b: Plane { x: 4.0, y: 0.5 },
        pivot_c: Plane { x: 3.0, y: 3.5 },
    };

    const MOTOR: MotorAndLegs = MotorAndLegs {
        crank: 1.0,
        a: 2.0,
        b: 2.2,
        c: 2.4,
        p: 1.0,
        q: 1.2,
        delta: 0.8,
        pivot_b: Plane { x: 4.0, y: 0.5 },
        pivot_c: Plane { x: 3.0, y: 3.5 },
    };

    /// A number between -1 and 1 that depends on its sample and its index.
    fn mixed(sample: u32, index: usize) -> f64 {
        (12.9898 * (f64::from(sample) + 0.7) * (super::super::line::count(index) + 1.3)).sin()
    }

    /// Compares the polynomials with the closure, at inputs that have nothing in common and in all positions at the
    /// first of them where there are some.
    fn assert_is_the_closure<M: Mechanism<Scalar = f64>>(mechanism: &M, direction: &[f64]) {
        let functions = Of::<M>::FUNCTIONS;
        let sought = SoughtMechanism {
            functions,
            parameters: NumberRow::from(mechanism.parameters().as_ref()),
        };
        let from = NumberRow::from_fn(direction.len(), |input| 0.4 + mixed(0, input).abs());
        let line = InputLine::new(&sought, from, NumberRow::from(direction), Some([-2.0, 3.0]));
        let along = AlongLine::new(&sought, functions, &line).expect("it is algebraic");
        let closure = &along.closure;
        let values = |s: f64, unknowns: &[f64]| -> Vec<f64> {
            let mut at = Vec::from([along.from + along.rate * s]);
            at.extend(unknowns);
            if let Some((added, sign)) = closure.added {
                at[0] += f64::from(sign) * at[added];
            }
            let mut variables = closure.quantities.variables(&at);
            if let Some(angle) = closure.slide_angle {
                let first = usize::from(closure.quantities.first(angle));
                variables[first] *= at[0];
                variables[first + 1] *= at[0];
            }
            let equations = closure.equations.iter();
            equations.map(|equation| equation.value(&variables)).collect()
        };
        let mut positions = 0;
        for sample in 0..10 {
            let s = 2.0 * mixed(sample, 0);
            let unknowns = NumberRow::from_fn(sought.unknowns().len(), |unknown| {
                let size = match closure.quantities.kind(unknown + 1) {
                    ClosureQuantity::Angle => 3.0,
                    ClosureQuantity::Plain => 4.0,
                };
                size * mixed(sample, unknown + 1)
            });
            // sums of less than ten terms below 100
            let tolerance = 1000.0 * f64::EPSILON;
            let expected = sought.residuals(&line.inputs(s), &unknowns);
            for (value, expected) in values(s, &unknowns).iter().zip(expected.iter()) {
                assert!(
                    (value - expected).abs() < tolerance,
                    "{value} {expected} {}",
                    M::DESCRIPTION.name
                );
            }
            if positions > 0 {
                continue;
            }
            let inputs = M::Inputs::from_fn(|input| line.inputs(s)[input]);
            let found = mechanism.positions_at(inputs, |_, unknowns| {
                positions += 1;
                for value in values(s, unknowns.as_ref()) {
                    assert!(value.abs() < tolerance, "{value} {}", M::DESCRIPTION.name);
                }
            });
            assert!(found.is_ok(), "{found:?}");
        }
        assert!(positions > 0, "{} closes nowhere", M::DESCRIPTION.name);
    }

    /// The polynomials have the values of the closure, anywhere and in positions, where they vanish.
    #[test]
    fn the_polynomials_are_the_closure() {
        let at = |x: f64, y: f64| Plane::new(x, y);
        let (p, q) = (at(1.5, 0.8), at(1.2, -0.6));
        #[rustfmt::skip]
        let six_bars = (
            StephensonIByDyad { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, q, r5: 2.5, r6: 2.0 },
            StephensonII { r1: 4.0, r2: 2.0, r3: 1.5, r4: 1.2, p, q, r5: 1.6, r6: 3.0 },
            WattIByDyad { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, q, r5: 2.5, r6: 2.0 },
            WattIIByCouplers { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, arm: p, pivot: at(7.0, 0.0), r5: 3.0, r6: 2.5 },
            StephensonIIIByDyad { r1: 4.0, r2: 1.0, r3: 3.0, r4: 2.5, p, r5: 3.0, pivot: at(5.0, 3.0), r6: 2.5 },
        );
        for rate in [1.0, -2.0] {
            assert_is_the_closure(&six_bars.0, &[rate]);
            assert_is_the_closure(&six_bars.1, &[rate]);
            assert_is_the_closure(&six_bars.2, &[rate]);
            assert_is_the_closure(&six_bars.3, &[rate]);
            assert_is_the_closure(&six_bars.4, &[rate]);
        }
        let triad = ClassThreeTriad {
            base_b: at(3.4, 0.0),
            base_c: at(1.7, 3.0),
            platform_b: at(1.7, 0.0),
            platform_c: at(0.8, 1.5),
        };
        for direction in [[1.0, 0.0, 0.0], [0.0, -0.7, 0.0], [0.3, 1.0, -0.2]] {
            assert_is_the_closure(&triad, &direction);
        }
        let chain: RockerAndTriad = RockerAndTriad {
            ground: 4.0,
            crank: 1.0,
            coupler: 3.0,
            rocker: 2.5,
            arm: 1.0,
            a: 2.0,
            b: 2.2,
            c: 2.4,
            p: 1.0,
            q: 1.2,
            delta: 0.8,
            pivot_b: at(4.0, 0.5),
            pivot_c: at(3.0, 3.5),
        };
        assert_is_the_closure(&chain, &[1.0]);
        assert_is_the_closure(&CYLINDER, &[0.8]);
        assert_is_the_closure(&MOTOR, &[1.0]);
        let guide: TurnedGuide = TurnedGuide {
            crank: 1.0,
            a: 2.0,
            c: 2.4,
            p: 1.0,
            delta: 0.8,
            pivot_b: at(2.0, 0.5),
            pivot_c: at(1.0, 2.5),
        };
        assert_is_the_closure(&guide, &[1.0]);
    }

    /// The limits of a closure that was fitted to its values, before the macro stated it, to all their digits.
    #[test]
    fn limits_are_those_of_a_fitted_closure() {
        let ends = |data: &CycleData, expected: &[f64]| {
            assert!(data.is_complete(), "{:?}", data.incomplete());
            let branches = data.branches().iter();
            let limits = branches
                .flat_map(Branch::ends)
                .filter(|end| end.limit() == Some(LimitKind::TurningPoint));
            let limits: Vec<f64> = limits.map(|end| end.input.abs()).collect();
            let is_near = |one: f64, other: f64| (one - other).abs() < 1e-12;
            assert!(
                limits
                    .iter()
                    .all(|one| expected.iter().any(|other| is_near(*one, *other)))
            );
            assert!(
                expected
                    .iter()
                    .all(|other| limits.iter().any(|one| is_near(*one, *other)))
            );
        };
        // both are symmetric in the input
        let cylinder = CYLINDER.cycle().unwrap();
        ends(
            &cylinder,
            &[
                1.036_391_148_670_844_4,
                3.946_738_672_685_658,
                4.968_763_010_086_766,
                6.109_591_871_381_949,
            ],
        );
        assert_eq!((cylinder.circuits().len(), cylinder.branches().len()), (4, 8));
        let motor = MOTOR.cycle().unwrap();
        ends(&motor, &[2.948_801_866_852_293]);
        assert_eq!((motor.circuits().len(), motor.branches().len()), (1, 2));
    }

    /// A gear whose ratio is a dimension leaves no polynomials.
    #[test]
    fn a_gear_of_any_ratio_is_not_algebraic() {
        let geared: GearAndLegs = GearAndLegs {
            a: 0.5,
            b: 2.2,
            c: 2.4,
            p: 1.0,
            q: 1.2,
            ratio: 0.37,
            pivot_b: Plane::new(4.0, 0.5),
            pivot_c: Plane::new(3.0, 3.5),
        };
        let found = geared.cycle_over(0.0..=0.1).unwrap();
        assert_eq!(found.incomplete(), [Incomplete::NotAlgebraic]);
    }
}
