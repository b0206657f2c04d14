//! Singular values of Jacobians along sweeps, against those of nalgebra, against known robots and next to singular
//! poses.
#![cfg(feature = "alloc")]

use core::f64::consts::{FRAC_PI_4, PI, TAU};
use std::string::ToString;
use std::vec::Vec;

use super::{ExtremeKind, ExtremesError};
use crate::any::AssemblyChoice;
use crate::assembly::Assembly;
use crate::library::{ClassThreeTriad, FiveBar, FourBar};
use crate::linkage::AnyLinkage;
use crate::mechanism::{Jacobian, JacobianError, JacobianMeasure, Mechanism};
use crate::number::{Number, Row};
use crate::sweep::samples::{CRANK_ROCKER, LIMITED, triad};
use crate::sweep::{Local, Swept};

use JacobianMeasure::{
    ConditionNumber, InverseConditionNumber, LargestSingularValue, Manipulability, SmallestSingularValue,
};

const ROBOT: FiveBar = FiveBar {
    ground: 2.0,
    left: 1.5,
    left_rod: 2.0,
    right_rod: 2.0,
    right: 1.5,
};

crate::mechanism! {
    /// A plane robot arm of two links.
    struct Arm { upper: Length, fore: Length }
    input shoulder: Angle, elbow: Angle;
    unknown lean: Angle;
    lean == shoulder + elbow;
    output hand: Point = upper * cis(shoulder) + fore * cis(lean);
}

/// Isotropic where the elbow is bent by 135 degrees. (J. K. Salisbury & J. J. Craig, Articulated hands: force control
/// and kinematic issues, International Journal of Robotics Research 1, no. 1, 1982, 4-17.)
const ARM: Arm = Arm {
    upper: core::f64::consts::SQRT_2,
    fore: 1.0,
};

/// The singular values of rows, the largest first.
fn expected<const HEIGHT: usize, const WIDTH: usize>(rows: [[f64; WIDTH]; HEIGHT]) -> Vec<f64> {
    let entries = rows.iter().flatten().copied();
    let matrix = nalgebra::DMatrix::from_row_iterator(HEIGHT, WIDTH, entries);
    let mut values: Vec<f64> = matrix.singular_values().iter().copied().collect();
    values.sort_by(|one, other| other.total_cmp(one));
    values
}

fn close(one: f64, other: f64, allowed: f64) {
    assert!((one - other).abs() <= allowed * (1.0 + other.abs()), "{one} {other}");
}

/// The hand's Jacobian by the equation of each rod e: e · v = e · k' for the velocity k' of the crank's end. (C.
/// Gosselin & J. Angeles, Singularity analysis of closed-loop kinematic chains, IEEE Transactions on Robotics and
/// Automation 6, 1990, 281-290.)
fn by_rods(robot: &FiveBar, cranks: [f64; 2], hand: [f64; 2]) -> [[f64; 2]; 2] {
    let rods = [(robot.left, 0.0), (robot.right, robot.ground)];
    let lines: Vec<[f64; 3]> = (0..2)
        .map(|side| {
            let ((length, pivot), (sine, cosine)) = (rods[side], cranks[side].sin_cos());
            let rod = [hand[0] - pivot - length * cosine, hand[1] - length * sine];
            [rod[0], rod[1], length * (rod[1] * cosine - rod[0] * sine)]
        })
        .collect();
    let [[a, b, e], [c, d, f]] = [lines[0], lines[1]];
    let determinant = a * d - b * c;
    [
        [d * e / determinant, -b * f / determinant],
        [-c * e / determinant, a * f / determinant],
    ]
}

/// At every row, by the matrix of the pose, by the rods, and by nalgebra.
#[test]
fn of_the_rows_are_those_of_the_poses() {
    let way = ROBOT.sweep(Assembly::Open).between([2.1, 1.0], [1.2, 1.9], 60);
    let columns = [
        LargestSingularValue,
        SmallestSingularValue,
        ConditionNumber,
        InverseConditionNumber,
        Manipulability,
    ]
    .map(|measure| way.of_jacobian(&["hand"], measure).column().unwrap());
    let table = way.table().unwrap();
    for (row, values) in table.rows().enumerate() {
        let cranks = ["alpha", "beta"].map(|name| values.get(name).unwrap());
        let pose = ROBOT.position(cranks[0], cranks[1], Assembly::Open).unwrap();
        let hand = [pose.hand.x().position(), pose.hand.y().position()];
        let [_, _, x, y] = ROBOT.jacobian(&pose).unwrap();
        let expected = expected([x, y]);
        for (one, other) in [x, y].iter().zip(by_rods(&ROBOT, cranks, hand)) {
            close(one[0], other[0], 1e-13);
            close(one[1], other[1], 1e-13);
        }
        let of_the_pose = ROBOT.jacobian_of(&pose, &["hand.x", "hand.y"]).unwrap();
        for (index, value) in of_the_pose.singular_values().into_iter().enumerate() {
            close(value, expected[index], 1e-13);
            close(columns[index][row], expected[index], 1e-13);
        }
        close(columns[2][row], expected[0] / expected[1], 1e-12);
        close(columns[3][row], expected[1] / expected[0], 1e-12);
        close(columns[4][row], (x[0] * y[1] - x[1] * y[0]).abs(), 1e-12);
    }
}

/// Values and derivatives with respect to the variable: a closure's matrix, the measure by its name, and poses beside
/// it.
fn derivatives_agree<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    from: M::Inputs<f64>,
    to: M::Inputs<f64>,
    assembly: M::Assembly,
    results: &[&str],
) {
    let way = mechanism.sweep(assembly).between(from, to, 9);
    let any = AnyLinkage::of(mechanism);
    let any = any
        .sweep(AssemblyChoice::of::<M>(assembly))
        .between(from.as_ref(), to.as_ref(), 9);
    for measure in [LargestSingularValue, SmallestSingularValue, InverseConditionNumber] {
        let of_expression = way.of_expression(|at| Ok::<_, JacobianError>(at.jacobian_of(results)?.measure(measure)));
        let named = way.of_jacobian(results, measure);
        assert_eq!(
            named.extremes().unwrap(),
            any.of_jacobian(results, measure).extremes().unwrap()
        );
        let (one, other) = (of_expression.extremes().unwrap(), named.extremes().unwrap());
        assert_eq!(one.len(), other.len(), "{measure:?}: {one:?} {other:?}");
        for (one, other) in one.iter().zip(&other) {
            close(one.value.unwrap(), other.value.unwrap(), 1e-12);
            close(one.at, other.at, 1e-7);
        }
        // the derivatives, by Taylor's formula
        let at = |part: f64| {
            let along = |input: usize| from[input] + (to[input] - from[input]) * part;
            let inputs = M::Inputs::<f64>::from_fn(along);
            let near = mechanism
                .sweep(assembly)
                .between(inputs, to, 2)
                .of_jacobian(results, measure)
                .column();
            near.unwrap()[0]
        };
        let step = 1e-3;
        let slope =
            (8.0 * (at(0.4 + step) - at(0.4 - step)) - at(0.4 + 2.0 * step) + at(0.4 - 2.0 * step)) / (12.0 * step);
        let bend = (at(0.4 + step) - 2.0 * at(0.4) + at(0.4 - step)) / (step * step);
        let middle = M::Inputs::<f64>::from_fn(|input| from[input] + (to[input] - from[input]) * 0.4);
        let way = mechanism.sweep(assembly).between(middle, to, 2);
        let unit = 0.6 / (way.at(1) - way.at(0));
        for order in [1, 2] {
            let by_series = way
                .of_expression(|at| {
                    let measured = at.jacobian_of(results)?.measure(measure);
                    Ok::<_, JacobianError>(Local::constant(measured.derivatives()[order]))
                })
                .column()
                .unwrap()[0];
            let (found, expected) = (
                by_series / unit.powi(order.try_into().unwrap()),
                [slope, bend][order - 1],
            );
            close(found, expected, if order == 1 { 1e-8 } else { 1e-4 });
        }
    }
}

#[test]
fn have_derivatives_along_the_sweep() {
    derivatives_agree(&ROBOT, [2.1, 1.0], [1.8, 1.2], Assembly::Open, &["hand"]);
    derivatives_agree(&ARM, [0.2, 0.3], [0.9, 2.0], (), &["hand"]);
    derivatives_agree(&CRANK_ROCKER, [0.5], [2.9], Assembly::Crossed, &["theta3", "theta4"]);
}

/// A platform on three cylinders: lengths for each unit of length, in a coupled block.
#[test]
fn of_a_platform_on_cylinders() {
    let leg = 5.0_f64.sqrt();
    let platform = triad();
    let near = crate::assembly::Near([0.1, 2.2, -2.0, 1.6]);
    let way = platform.sweep(near).between([leg; 3], [leg + 0.2, leg - 0.1, leg], 5);
    let smallest = way.of_jacobian(&["centre"], SmallestSingularValue);
    let column = smallest.column().unwrap();
    for (row, pose) in way.rows().enumerate() {
        let pose = pose.unwrap();
        let jacobian = platform.jacobian(&pose).unwrap();
        let count = ClassThreeTriad::<f64>::DESCRIPTION.unknowns.len();
        close(column[row], expected([jacobian[count], jacobian[count + 1]])[1], 1e-12);
    }
    let lowest = smallest.lowest().unwrap();
    assert!(
        column.iter().all(|value| *value >= lowest.value - 1e-12),
        "{lowest} {column:?}"
    );
}

/// With one input, the singular value of one row is the size of a velocity at unit speed: at limits and at change
/// points, too.
#[test]
fn of_one_input_are_speeds() {
    let check = |linkage: FourBar, from: f64, to: f64| {
        let way = linkage.sweep(Assembly::Open).over(from..=to, 31).speed(1.0);
        let speed = way.of_expression(|at| at.theta4.velocity().abs()).extremes().unwrap();
        let value = way.of_jacobian(&["theta4"], SmallestSingularValue).extremes().unwrap();
        assert_eq!(speed.len(), value.len(), "{speed:?} {value:?}");
        for (one, other) in speed.iter().zip(&value) {
            assert_eq!(
                (one.kind, one.is_maximum),
                (other.kind, other.is_maximum),
                "{one:?} {other:?}"
            );
            close(one.at, other.at, 1e-9);
            close(one.value.unwrap_or(0.0), other.value.unwrap_or(0.0), 1e-8);
        }
        speed.into_iter().map(|extreme| extreme.kind).collect::<Vec<_>>()
    };
    let kinds = check(CRANK_ROCKER, 0.0, TAU);
    // the rocker rests at both ends of its swing, where its speed has a kink
    assert_eq!(
        kinds.iter().filter(|kind| **kind == ExtremeKind::Kink).count(),
        2,
        "{kinds:?}"
    );
    let kinds = check(LIMITED, -3.0, 3.0);
    assert!(kinds.contains(&ExtremeKind::Unbounded), "{kinds:?}");
    let change_point = FourBar {
        r1: 3.0,
        r2: 4.0,
        r3: 7.0,
        r4: 6.0,
    };
    let kinds = check(change_point, 6.0, 6.5);
    assert!(kinds.contains(&ExtremeKind::Kink), "{kinds:?}");
}

/// The arm's only isotropic pose, where both singular values meet, and its stretched pose.
#[test]
fn of_an_arm() {
    let bend = ARM.sweep().between([0.3, 0.1], [0.3, 3.0], 12);
    let best = bend.of_jacobian(&["hand"], ConditionNumber).lowest().unwrap();
    close(best.at, 3.0 * FRAC_PI_4, 1e-8);
    close(best.value, 1.0, 1e-8);
    assert_eq!(best.kind, ExtremeKind::Kink);
    // the area of the triangle of both links, twice
    let area = bend.of_jacobian(&["hand"], Manipulability).highest().unwrap();
    close(area.value, ARM.upper * ARM.fore, 1e-13);
    close(area.at, PI / 2.0, 1e-9);
    let crossings = bend.of_jacobian(&["hand"], ConditionNumber).crossings(2.0).unwrap();
    assert_eq!(crossings.len(), 2, "{crossings:?}");
    for crossing in crossings {
        let (pose_sine, pose_cosine) = crossing.at.sin_cos();
        // κ + 1/κ is the sum of squares over the determinant
        let squares = ARM.upper * ARM.upper + 2.0 + 2.0 * ARM.upper * pose_cosine;
        close(squares / (ARM.upper * pose_sine), 2.5, 1e-12);
    }

    // through the stretched pose, on a row and between rows
    for rows in [20, 21] {
        let through = ARM.sweep().between([0.3, -1.0], [0.3, 1.0], rows);
        let smallest = through.of_jacobian(&["hand"], SmallestSingularValue).lowest().unwrap();
        assert!(smallest.value.abs() < 1e-9 && smallest.at.abs() < 1e-9, "{smallest:?}");
        assert_eq!(smallest.kind, ExtremeKind::Kink);
        let inverse = through.of_jacobian(&["hand"], InverseConditionNumber).lowest().unwrap();
        assert!(inverse.value.abs() < 1e-9 && inverse.at.abs() < 1e-9, "{inverse:?}");
        let error = through.of_jacobian(&["hand"], ConditionNumber).highest().unwrap_err();
        assert!(
            matches!(error, ExtremesError::Unbounded { at } | ExtremesError::NotFinite { at } if at.abs() < 1e-9),
            "{error:?}"
        );
        let column = through.of_jacobian(&["hand"], ConditionNumber).column().unwrap();
        assert!(column.iter().all(|value| *value >= 1.0), "{column:?}");
    }

    // The largest singular value is that of the stretched arm, with √((a + b)² + b²).
    let through = ARM.sweep().between([0.3, -1.1], [0.3, 1.0], 20);
    let found = through
        .of_jacobian(&["hand"], LargestSingularValue)
        .peak_sensitivities()
        .unwrap();
    let value = (ARM.upper + ARM.fore).hypot(ARM.fore);
    close(found.peak.value, value, 1e-14);
    assert!(found.peak.at.abs() < 1e-9);
    close(found.by[0].value, (ARM.upper + ARM.fore) / value, 1e-12);
    close(found.by[1].value, (ARM.upper + 2.0 * ARM.fore) / value, 1e-12);
    assert!(found.by.iter().all(|by| by.at.abs() < 1e-9), "{found:?}");
}

/// Where both rods of a five-bar are in line, the cranks cannot hold the hand; where a crank and its rod are, the hand
/// cannot move along them.
#[test]
fn next_to_singular_poses() {
    // both cranks outwards until the rods are stretched
    let outwards = ROBOT
        .sweep(Assembly::Open)
        .between([2.0, PI - 2.0], [3.0, PI - 3.0], 30);
    let error = outwards.of_jacobian(&["hand"], ConditionNumber).highest().unwrap_err();
    let limit = outwards.table().unwrap().limits()[0].at;
    close(1.0 - ROBOT.left * limit.cos(), 2.0, 1e-12);
    assert!(
        matches!(error, ExtremesError::Unbounded { at } if (at - limit).abs() < 1e-12),
        "{error:?}"
    );
    let column = outwards.of_jacobian(&["hand"], SmallestSingularValue).column().unwrap();
    assert!(column[0].is_finite() && column[29].is_nan());
    let inverse = outwards
        .of_jacobian(&["hand"], InverseConditionNumber)
        .lowest()
        .unwrap();
    assert!(
        inverse.value.abs() < 1e-6 && inverse.kind == ExtremeKind::Limit,
        "{inverse:?}"
    );

    // The left crank passes under the hand, which stands still: its velocity changes the direction.
    let way = ROBOT.sweep(Assembly::Open).between([0.2, 0.8], [2.0, 0.8], 40);
    let lowest = way.of_jacobian(&["hand"], SmallestSingularValue).lowest().unwrap();
    assert!(lowest.value >= 0.0, "{lowest:?}");
}

#[test]
fn mistakes_are_reported() {
    let way = ROBOT.sweep(Assembly::Open).between([2.1, 1.0], [1.8, 1.2], 5);
    let error = way.of_jacobian(&["hnd"], ConditionNumber).highest().unwrap_err();
    let message = "no unknown and no output is called `hnd`: there are phi, psi, hand.x, hand.y";
    assert_eq!(error.to_string(), message);
    let error = way.of_jacobian(&["hand", "phi"], ConditionNumber).column().unwrap_err();
    let ExtremesError::Jacobian(error) = error else {
        panic!("{error:?}");
    };
    let JacobianError::MixedDimensions { one, other } = *error else {
        panic!("{error:?}");
    };
    assert_eq!((one.as_str(), other.as_str()), ("hand.x", "phi"));
    let error = way.of_jacobian(&[], ConditionNumber).lowest().unwrap_err();
    assert_eq!(error, ExtremesError::Jacobian(JacobianError::Empty.into()));
    let of_expression = way.of_expression(|at| {
        at.jacobian_of(&["phi", "hand"])
            .map(|jacobian| jacobian.condition_number())
    });
    assert!(matches!(of_expression.lowest(), Err(ExtremesError::Jacobian(_))));
    // divided by a separate length
    let scaled = way.of_expression(|at| {
        let [phi, _, x, y] = at.jacobian()?;
        let rows = [phi, x.map(|entry| entry / 1.5), y.map(|entry| entry / 1.5)];
        Ok::<_, JacobianError>(Jacobian::from_rows(&rows).condition_number())
    });
    assert!(scaled.lowest().unwrap().value > 1.0);
}
