//! The units that are understood, each with its size in SI.

use std::f64::consts::{PI, TAU};

/// A unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Unit {
    /// Its name.
    pub(crate) name: &'static str,
    /// Its size in metres, kilograms, seconds, newtons and radians.
    pub(crate) size: f64,
}

/// The units of one kind of quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Kind {
    /// The quantity, with its article.
    pub(crate) name: &'static str,
    /// The power of lengths in it.
    pub(crate) lengths: i32,
    /// The units. Messages write the first.
    pub(crate) units: &'static [Unit],
}

const fn unit(name: &'static str, size: f64) -> Unit {
    Unit { name, size }
}

const DEGREE: f64 = PI / 180.0;
const INCH: f64 = 0.0254;
const POUND: f64 = 0.453_592_37;

pub(crate) const LENGTH: Kind = Kind {
    name: "a length",
    lengths: 1,
    units: &[
        unit("mm", 1e-3),
        unit("cm", 1e-2),
        unit("m", 1.0),
        unit("um", 1e-6),
        unit("µm", 1e-6),
        unit("in", INCH),
        unit("ft", 12.0 * INCH),
    ],
};
pub(crate) const ANGLE: Kind = Kind {
    name: "an angle",
    lengths: 0,
    units: &[
        unit("deg", DEGREE),
        unit("°", DEGREE),
        unit("rad", 1.0),
        unit("turn", TAU),
        unit("turns", TAU),
    ],
};
pub(crate) const MASS: Kind = Kind {
    name: "a mass",
    lengths: 0,
    units: &[unit("kg", 1.0), unit("g", 1e-3), unit("t", 1e3), unit("lb", POUND)],
};
pub(crate) const ACCELERATION: Kind = Kind {
    name: "an acceleration",
    lengths: 1,
    units: &[
        unit("m/s2", 1.0),
        unit("mm/s2", 1e-3),
        unit("in/s2", INCH),
        unit("ft/s2", 12.0 * INCH),
    ],
};
pub(crate) const FORCE: Kind = Kind {
    name: "a force",
    lengths: 1,
    units: &[
        unit("N", 1.0),
        unit("kN", 1e3),
        unit("mN", 1e-3),
        unit("lbf", POUND * 9.806_65),
    ],
};
pub(crate) const TORQUE: Kind = Kind {
    name: "a torque",
    lengths: 2,
    units: &[
        unit("Nm", 1.0),
        unit("Nmm", 1e-3),
        unit("Ncm", 1e-2),
        unit("kNm", 1e3),
        unit("lbfin", POUND * 9.806_65 * INCH),
    ],
};
pub(crate) const INERTIA: Kind = Kind {
    name: "a moment of inertia",
    lengths: 2,
    units: &[
        unit("kgm2", 1.0),
        unit("kgcm2", 1e-4),
        unit("kgmm2", 1e-6),
        unit("gcm2", 1e-7),
        unit("gmm2", 1e-9),
    ],
};
pub(crate) const STIFFNESS: Kind = Kind {
    name: "a stiffness",
    lengths: 0,
    units: &[unit("N/m", 1.0), unit("N/mm", 1e3), unit("kN/m", 1e3)],
};
pub(crate) const TORSION_STIFFNESS: Kind = Kind {
    name: "a stiffness by angle",
    lengths: 2,
    units: &[
        unit("Nm/rad", 1.0),
        unit("Nm/deg", 1.0 / DEGREE),
        unit("Nmm/rad", 1e-3),
        unit("Nmm/deg", 1e-3 / DEGREE),
    ],
};
pub(crate) const DAMPING: Kind = Kind {
    name: "a damping",
    lengths: 0,
    units: &[unit("Ns/m", 1.0), unit("Ns/mm", 1e3)],
};
pub(crate) const TORSION_DAMPING: Kind = Kind {
    name: "a damping by angle",
    lengths: 2,
    units: &[
        unit("Nms/rad", 1.0),
        unit("Nms/deg", 1.0 / DEGREE),
        unit("Nmms/rad", 1e-3),
    ],
};

/// The units of the speed of an angle, each with what multiplies a number and what then divides it, so that `60rpm` is
/// 2π exactly.
const SPEEDS: [(&str, f64, f64); 9] = [
    ("rpm", TAU, 60.0),
    ("1/min", TAU, 60.0),
    ("turn/min", TAU, 60.0),
    ("Hz", TAU, 1.0),
    ("1/s", TAU, 1.0),
    ("turn/s", TAU, 1.0),
    ("rad/s", 1.0, 1.0),
    ("deg/s", PI, 180.0),
    ("°/s", PI, 180.0),
];

/// The speed of an angle, in radians by second; none if the unit is not that of one.
pub(crate) fn speed_of_angle(number: f64, name: &str) -> Option<f64> {
    let (_, by, over) = SPEEDS.into_iter().find(|(unit, ..)| *unit == name)?;
    Some(number * by / over)
}

/// The names of all units that begin with a letter, and so can follow a number.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    let kinds = [
        LENGTH,
        ANGLE,
        MASS,
        ACCELERATION,
        FORCE,
        TORQUE,
        INERTIA,
        STIFFNESS,
        TORSION_STIFFNESS,
        DAMPING,
        TORSION_DAMPING,
    ];
    let kinds = kinds
        .into_iter()
        .flat_map(|kind| kind.units.iter().map(|unit| unit.name));
    let names = kinds.chain(SPEEDS.into_iter().map(|(name, ..)| name));
    names.filter(|name| name.starts_with(char::is_alphabetic))
}

impl Kind {
    /// The unit of a name. Signs of products and powers may be written: `kg*m^2`.
    pub(crate) fn unit(self, name: &str) -> Option<Unit> {
        let plain = name.replace(['*', '^', '·', ' '], "").replace('²', "2");
        self.units.iter().copied().find(|unit| unit.name == plain)
    }

    /// Its units in words. Those that are not on a keyboard are left out.
    pub(crate) fn listed(self) -> String {
        let typed = self
            .units
            .iter()
            .filter(|unit| unit.name.is_ascii() && unit.name != "turns");
        let names: Vec<String> = typed.map(|unit| format!("`{}`", unit.name)).collect();
        match names.as_slice() {
            [some @ .., last] if !some.is_empty() => format!("{} or {last}", some.join(", ")),
            names => names.concat(),
        }
    }
}
