//! Section 6: the notes' sample values, a four-bar linkage in centimetres.
//!
//! This linkage is no crank-rocker: it closes only while `e <= 105`, that is
//! `|theta2| <= 112.02` degrees. The values are those of the open assembly.

use super::four_bar_geometric::Dimensions;

/// The links, in centimetres.
pub const DIMENSIONS: Dimensions = Dimensions {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};

/// The crank's motion, in radians. The notes give it through jerk; the snap is
/// ours.
pub const THETA2: [f64; 5] = [65f64.to_radians(), -10.0, 2.0, -0.5, 0.3];

/// The largest angle of the crank at which the linkage closes, either way.
pub const THETA2_LIMIT: Printed = Printed::new(112.02, 2);

/// A number with as many decimals as were printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Printed {
    /// The number.
    pub value: f64,
    /// How many digits stand after its decimal point.
    pub decimals: i32,
}

impl Printed {
    /// The number `value` as it is printed with so many decimals.
    #[must_use]
    pub const fn new(value: f64, decimals: i32) -> Self {
        Self { value, decimals }
    }

    /// Half a unit of the last digit printed.
    #[must_use]
    pub fn tolerance(self) -> f64 {
        0.5 * 10f64.powi(-self.decimals)
    }

    /// Whether `found` rounds to this number, but for the last four bits of a
    /// double: the longest of them are printed to the fifteenth digit.
    #[must_use]
    pub fn agrees(self, found: f64) -> bool {
        let rounding = 16.0 * f64::EPSILON * self.value.abs();
        (found - self.value).abs() <= self.tolerance() + rounding
    }
}

/// One line of the notes' table, and the snap that goes with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The notes' name of the quantity.
    pub name: &'static str,
    /// The position is an angle, printed in degrees. (Rates are in radians.)
    pub in_degrees: bool,
    /// Position, velocity, acceleration, jerk, snap. The snap is not in the
    /// notes: it was computed in 50-digit arithmetic.
    pub printed: [Printed; 5],
}

impl Row {
    /// The values in radians and centimetres.
    #[must_use]
    pub fn values(&self) -> [f64; 5] {
        let mut values = self.printed.map(|printed| printed.value);
        if self.in_degrees {
            values[0] = values[0].to_radians();
        }
        values
    }

    /// Holds a quantity, in radians and centimetres, against every digit
    /// printed. Fewer than five orders may be given.
    ///
    /// # Panics
    ///
    /// If one of them does not round to what is printed.
    #[track_caller]
    pub fn assert_agrees<const N: usize>(&self, found: [f64; N]) {
        for (order, (mut found, printed)) in found.into_iter().zip(self.printed).enumerate() {
            if self.in_degrees && order == 0 {
                found = found.to_degrees();
            }
            assert!(
                printed.agrees(found),
                "{}, order {order}: found {found}, printed {}",
                self.name,
                printed.value,
            );
        }
    }
}

/// The diagonal.
pub const E: Row = Row {
    name: "e",
    in_degrees: false,
    printed: [
        Printed::new(81.9626, 4),
        Printed::new(-298.5547, 4),
        Printed::new(364.3867, 4),
        Printed::new(32987.0, 0),
        Printed::new(301_182.221_3, 4),
    ],
};

/// The angle at D between ground and diagonal.
pub const ALPHA: Row = Row {
    name: "alpha",
    in_degrees: true,
    printed: [
        Printed::new(19.3737, 4),
        Printed::new(-0.3588, 4),
        Printed::new(-38.9682, 4),
        Printed::new(-363.3719, 4),
        Printed::new(-118.844_906_7, 7),
    ],
};

/// The angle at C between coupler and rocker.
pub const GAMMA: Row = Row {
    name: "gamma",
    in_degrees: true,
    printed: [
        Printed::new(101.6763, 4),
        Printed::new(-9.2546, 4),
        Printed::new(62.7055, 4),
        Printed::new(-253.3073, 4),
        Printed::new(29671.03572, 5),
    ],
};

/// The angle at D between diagonal and rocker.
pub const BETA: Row = Row {
    name: "beta",
    in_degrees: true,
    printed: [
        Printed::new(45.7986, 4),
        Printed::new(5.7122, 4),
        Printed::new(-30.8, 4),
        Printed::new(125.9668, 4),
        Printed::new(-19155.29705, 5),
    ],
};

/// The rocker's angle.
pub const THETA4: Row = Row {
    name: "theta4",
    in_degrees: true,
    printed: [
        Printed::new(114.8278, 4),
        Printed::new(-5.3533, 4),
        Printed::new(69.7682, 4),
        Printed::new(237.4051, 4),
        Printed::new(19_274.141_958_684_7, 10),
    ],
};

/// The coupler's angle.
pub const THETA3: Row = Row {
    name: "theta3",
    in_degrees: true,
    printed: [
        Printed::new(13.1515, 4),
        Printed::new(3.9013, 4),
        Printed::new(7.0627, 4),
        Printed::new(490.7125, 4),
        Printed::new(-10_396.893_761_444_9, 10),
    ],
};

/// The whole table, in the notes' order.
pub const TABLE: [Row; 6] = [E, ALPHA, GAMMA, BETA, THETA4, THETA3];
