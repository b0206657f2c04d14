//! Declarations among items whose names mean something else.
#![allow(unreachable_pub, missing_docs, non_snake_case)]

use kin_core::prelude::{Mechanism, Motion as KinMotion};

/// A slider-crank and a four-bar under the names given, wherever the macro is used.
macro_rules! declare {
    ($slider:ident, $linkage:ident) => {
        kin_core::mechanism! {
            pub struct $slider { pub r: Length, pub l: Length }
            input theta: Angle;
            unknown phi: Angle, s: Length;
            r * sin(theta) == l * sin(phi);
            s == r * cos(theta) + l * cos(phi);
        }
        kin_core::mechanism! {
            pub struct $linkage { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
            input theta2: Angle;
            unknown theta3: Angle in -PI..=PI, theta4: Angle in 0.0..=PI;
            r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
            output pin: Point = r2 * cis(theta2);
            output root: Length = sqrt(r2 * r3) + asin(r2 / r1) * r4;
            with transmission_angles;
        }
    };
}

/// Every name that the prelude, the standard library or generated code could mean.
#[allow(non_camel_case_types, dead_code, non_upper_case_globals)]
mod own_items {
    pub struct Result;
    pub struct Option;
    pub struct Motion;
    pub struct Plane;
    pub struct Assembly;
    pub struct Failure;
    pub struct SolveError;
    pub struct String;
    pub struct Vec;
    pub struct Self_;
    pub struct S;
    pub struct T;
    pub struct V;
    pub struct f64;
    pub struct f32;
    pub struct usize;
    pub struct bool;
    pub struct str;
    pub trait Scalar {}
    pub trait Copy {}
    pub trait Clone {}
    pub trait Fn {}
    pub trait FnMut {}
    pub trait Mechanism {}
    pub trait Debug {}
    pub trait PartialEq {}
    pub trait Iterator {}
    pub fn sin() {}
    pub fn cos() {}
    pub fn sqrt() {}
    pub fn cis() {}
    pub fn position() {}
    pub fn solve() {}
    pub mod kin {}
    pub mod core {}
    pub mod std {}
    pub mod solve {}
    pub mod runtime {}
    #[allow(non_snake_case)]
    pub fn Ok() {}
    #[allow(non_snake_case)]
    pub fn Err() {}
    #[allow(non_snake_case)]
    pub fn Some() {}
    pub const None: u8 = 0;
    pub const PI: u8 = 3;
    pub const Open: u8 = 0;

    declare!(Slider, Linkage);
}

#[test]
fn own_items_are_not_taken_for_others() {
    let slider = own_items::Slider { r: 1.0, l: 3.0 };
    let pose = slider
        .solve(KinMotion::constant(0.0), kin_core::Assembly::Open)
        .expect("it closes");
    assert_eq!(pose.s.position(), 4.0);
    let linkage = own_items::Linkage {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    assert!(linkage.solve(KinMotion::constant(1.0)).is_ok());
}

#[test]
fn inside_of_a_function_and_a_block() {
    declare!(Slider, Linkage);
    let pose = {
        mod inner {
            declare!(Slider, Linkage);
            pub(super) fn linkage() -> Linkage {
                Linkage {
                    r1: 90.0,
                    r2: 30.0,
                    r3: 60.0,
                    r4: 45.0,
                }
            }
        }
        inner::linkage().position(1.0).expect("it closes")
    };
    let slider = Slider { r: 1.0, l: 3.0 };
    assert!(slider.position(1.0, kin_core::Assembly::Crossed).is_ok());
    assert_eq!(
        Linkage {
            r1: 90.0,
            r2: 30.0,
            r3: 60.0,
            r4: 45.0
        }
        .position(1.0)
        .map(|pose| kin_core::PoseOf::<Linkage>::unknowns(&pose).len()),
        Ok(2)
    );
    assert!(pose.pin.position().x > 0.0);
}

/// Private and restricted visibility, and nothing used: no warnings (they are errors in the fixture without the
/// standard library; here it must compile).
#[allow(dead_code)]
mod visibilities {
    kin_core::mechanism! {
        struct Private { r: Length, l: Length }
        input theta: Angle;
        unknown phi: Angle, s: Length;
        r * cis(theta) + l * cis(phi) == vec2(s, 0);
    }
    kin_core::mechanism! {
        pub(crate) struct Restricted { pub(crate) r: Length, pub(super) l: Length }
        input theta: Angle;
        unknown phi: Angle, s: Length;
        r * cis(theta) + l * cis(phi) == vec2(s, 0);
    }
}

/// Quantities that are called as the generated code calls its own.
mod names_of_the_generator {
    kin_core::mechanism! {
        pub struct Locals { pub assembly: Length, pub near: Length, pub result: Length, pub failure: Length,
            pub index: Length }
        input position: Angle, inputs: Length;
        unknown first: Angle, second: Angle, determinant: Length, candidate: Length where candidate > 0;

        near * cis(position) + result * cis(first) == assembly + failure * cis(second);
        determinant == inputs + index * sin(first);
        candidate.powi(2) == determinant.powi(2) + index.powi(2);

        let diagonal = near * 2;
        output diagonal_x: Length = determinant * cos(second);
        output velocity: Length = candidate - diagonal;
        output t: Point = near * cis(first);
    }

    kin_core::mechanism! {
        pub struct Rows { pub parameters: Length, pub convert: Length, pub unknowns: Length }
        input inverse_determinant: Angle;
        unknown right_1_velocity: Angle, this: Length;
        parameters * cis(inverse_determinant) + convert * cis(right_1_velocity) == vec2(this, unknowns);
    }
}

/// The same for what is requested, and the word that requests it.
mod names_of_requests {
    kin_core::mechanism! {
        pub struct Requests { pub unknowns: Length, pub along_1: Length, pub transmission_angles: Length,
            pub joint_0: Length }
        input pose: Angle, values: Length;
        unknown across_1: Angle, with: Angle, test: Length;
        along_1 * cis(pose) + transmission_angles * cis(across_1) == unknowns + joint_0 * cis(with);
        with == test / values;
        let inputs = along_1 * cis(pose);
        output skeleton: Point = inputs + joint_0 * cis(with);
        with transmission_angles;
    }
}

#[test]
fn requests_meet_no_name() {
    use names_of_requests::Requests;
    let mechanism: Requests = Requests {
        unknowns: 90.0,
        along_1: 30.0,
        transmission_angles: 60.0,
        joint_0: 45.0,
    };
    let pose = mechanism
        .position(1.0, 2.0, kin_core::Assembly::Open)
        .expect("it closes");
    let [transmission] = mechanism.transmission_angles(&pose);
    assert_eq!(transmission.block, "across_1, with");
    let between = pose.with.value() - pose.across_1.value();
    assert!((transmission.angle - between.abs()).abs() < 1e-14);
    let skeleton = mechanism.skeleton(&pose);
    let (name, point) = skeleton.points().next().expect("there is a point");
    assert_eq!(name, "skeleton");
    // as two programs compute it, of lengths that add up to 225
    assert!((point - pose.skeleton.value()).norm_squared().sqrt() <= 4.0 * f64::EPSILON * 225.0);
}

#[test]
fn quantities_may_be_called_anything() {
    use names_of_the_generator::{Locals, Rows};
    let mechanism: Locals = Locals {
        assembly: 90.0,
        near: 30.0,
        result: 60.0,
        failure: 45.0,
        index: 2.0,
    };
    let pose = mechanism
        .solve(
            KinMotion::new([1.0, 2.0, 3.0, 4.0, 5.0]),
            KinMotion::new([7.0, 1.0, 0.0, 0.0, 0.0]),
            kin_core::Assembly::Open,
        )
        .expect("it closes");
    assert!((pose.velocity.velocity() - pose.candidate.velocity()).abs() < 1e-12);
    assert!((pose.determinant.snap() - 2.0 * sine_snap(&pose.first)).abs() < 1e-9);
    let rows = Rows {
        parameters: 1.0,
        convert: 3.0,
        unknowns: 0.5,
    };
    assert!(rows.position(1.0, kin_core::Assembly::Open).is_ok());
}

fn sine_snap(angle: &KinMotion<f64, 5>) -> f64 {
    angle.sin_cos().0.snap()
}

/// Mechanisms that are called as something in the generated code.
#[allow(non_camel_case_types)]
mod names_of_mechanisms {
    macro_rules! named {
        ($($name:ident)*) => {$(
            pub mod $name {
                kin_core::mechanism! {
                    pub struct $name { pub r: Length, pub l: Length }
                    input theta: Angle;
                    unknown phi: Angle, s: Length;
                    r * cis(theta) + l * cis(phi) == vec2(s, 0);
                }
            }
        )*};
    }
    named! {
        kin Kin Result Option Some None Ok Err Near Motion Plane Assembly Mechanism Scalar S V f64 Number Element Place
    }
}

#[test]
fn mechanisms_may_be_called_anything() {
    fn stroke<M: Mechanism<Scalar = f64, Assembly = kin_core::Assembly>>() -> f64 {
        use kin_core::prelude::{Pose, Row};
        let mechanism = M::from_parameters(M::Parameters::from_fn(|index| [1.0, 3.0][index]));
        let inputs = M::Inputs::from_fn(|_| M::Motion::from_fn(|_| 0.0));
        let pose = mechanism.solve(inputs, kin_core::Assembly::Open).expect("it closes");
        pose.unknown_motions()[1][0]
    }
    use names_of_mechanisms as named;
    let strokes = [
        stroke::<named::kin::kin>(),
        stroke::<named::Kin::Kin>(),
        stroke::<named::Result::Result>(),
        stroke::<named::Option::Option>(),
        stroke::<named::Some::Some>(),
        stroke::<named::None::None>(),
        stroke::<named::Ok::Ok>(),
        stroke::<named::Err::Err>(),
        stroke::<named::Near::Near>(),
        stroke::<named::Motion::Motion>(),
        stroke::<named::Plane::Plane>(),
        stroke::<named::Assembly::Assembly>(),
        stroke::<named::Mechanism::Mechanism>(),
        stroke::<named::Scalar::Scalar>(),
        stroke::<named::S::S>(),
        stroke::<named::V::V>(),
        stroke::<named::f64::f64>(),
        stroke::<named::Number::Number>(),
        stroke::<named::Element::Element>(),
        stroke::<named::Place::Place>(),
    ];
    assert_eq!(strokes, [4.0; 20]);
}

/// Items that a pattern would mean if it could: they are called as quantities are, and as names that the generated code
/// makes.
#[allow(dead_code, non_upper_case_globals, non_camel_case_types)]
mod items_called_like_variables {
    macro_rules! items {
        (
            $constants:ident: $($constant:ident)*; $statics:ident: $($static:ident)*; units: $($unit:ident)*;
            tuples: $($tuple:ident)*; variants: $($variant:ident)*;
        ) => {
            $(pub const $constant: $constants = 0;)*
            $(pub static $static: $statics = 0;)*
            $(pub struct $unit;)*
            $(pub struct $tuple(u8);)*
            pub enum Variants { $($variant),* }
            #[allow(unused_imports)]
            pub use Variants::*;
        };
    }
    items! {
        u8: theta r l theta3 r1 t theta2_velocity sin_theta2 diagonal_x influence near unknowns angle sine power_2;
        u16: phi theta4 r2 t_2 theta3_velocity cos_theta2 diagonal_y determinant position pose inputs cosine index fill
            unknown_theta3 root;
        units: s r3 pin_x four_areas failure assembly convert visitor value quantity;
        tuples: r4 r3_x r3_y result candidate parameters joint_0 power_1 across_1;
        variants: theta2 r4_x r4_y first second decided equation_0 found values pin_y pin root_value along_1;
    }
    declare!(Slider, Linkage);

    kin_core::mechanism! {
        pub struct Triad {
            pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length, pub l: Length, pub t: Length,
            pub pivot: Point
        }
        input theta: Angle;
        unknown alpha: Direction, phi: Angle, theta3: Angle, psi: Angle;
        let joint = r1 * cis(theta) + r2 * cis(alpha);
        joint + l * cis(phi) == pivot + r3 * cis(theta3);
        joint + t * powi(cos(psi), 3) * cis(phi + 1) == r4 * cis(psi);
        output pin: Point = joint;
        with sensitivities;
    }
}

#[test]
fn items_of_other_kinds_are_not_taken_for_variables() {
    use items_called_like_variables::{Linkage, Slider};
    let slider = Slider { r: 1.0, l: 3.0 };
    let pose = slider.position(0.0, kin_core::Assembly::Open).expect("it closes");
    assert_eq!(pose.s.position(), 4.0);
    let linkage: Linkage = Linkage {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let pose = linkage.solve(KinMotion::constant(1.0)).expect("it closes");
    let residuals = linkage.closure(1.0, kin_core::PoseOf::<Linkage>::unknowns(&pose));
    assert!(residuals.iter().all(|residual| residual.abs() < 1e-12));
}

/// Quantities that are called as what every program has in scope.
mod names_of_the_prelude {
    use kin_core::prelude::*;

    mechanism! {
        pub struct Variants { pub Some: Length, pub Near: Length, pub Open: Length, pub Crossed: Length }
        input None: Angle;
        unknown Ok: Angle, Err: Angle;
        Near * cis(None) + Some * cis(Ok) == Open + Crossed * cis(Err);
        let drop = Some * cis(Ok);
        output Box: Point = drop;
        with sensitivities, transmission_angles;
    }

    mechanism! {
        pub struct Chosen { pub block: Length, pub results: Length, pub given: Length }
        input assembly: Angle, quantity: Angle;
        unknown near: Angle, failure: Angle, result: Angle in -PI/2..=PI/2;
        block * cis(assembly) + results * cis(near) == given + block * cis(failure);
        sin(result) == cos(quantity + near) / 2;
    }

    mechanism! {
        pub struct Underscored { pub assembly_: Length, pub near_: Length, pub size: Length }
        input position: Angle;
        unknown assembly: Angle, near: Angle;
        assembly_ * cis(position) + near_ * cis(assembly) == size + assembly_ * cis(near);
    }
}

#[test]
fn quantities_may_be_called_as_what_the_prelude_has() {
    use kin_core::prelude::*;
    use names_of_the_prelude::{Chosen, Underscored, Variants};
    let lengths = [90.0_f64, 30.0, 60.0, 45.0];
    let [open, near, some, crossed] = lengths;
    let mechanism = Variants {
        Some: some,
        Near: near,
        Open: open,
        Crossed: crossed,
    };
    let pose = mechanism
        .solve(KinMotion::constant(1.0), Assembly::Open)
        .expect("it closes");
    // a sum of two squares and a root of it
    assert!((pose.Box.value().norm_squared().sqrt() - some).abs() <= 2.0 * f64::EPSILON * some);
    let chosen = Chosen {
        block: 30.0,
        results: 60.0,
        given: 50.0,
    };
    let quantities = [1.0, 0.5].map(KinMotion::constant);
    let pose = chosen
        .solve(quantities[0], quantities[1], Assembly::Open)
        .expect("it closes");
    let motion = Mechanism::solve(&chosen, quantities, Assembly::Open).expect("it closes");
    assert_eq!(pose, motion);
    let culprit = chosen.solve(KinMotion::constant(f64::NAN), quantities[1], Assembly::Open);
    assert!(culprit.is_err_and(|error| error.to_string().contains("assembly")));
    let underscored = Underscored {
        assembly_: 30.0,
        near_: 60.0,
        size: 50.0,
    };
    let [first, second] = underscored.solve_all(KinMotion::constant(1.0));
    assert!(first.is_ok() && second.is_ok());
}

/// Blocks whose unknowns' names come to the same when they are joined.
mod joined_names {
    kin_core::mechanism! {
        pub struct Joined { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
        input theta: Angle;
        unknown a: Angle, b_c: Angle, a_b: Angle, c: Angle;
        r2 * cis(theta) + r3 * cis(a) == r1 + r4 * cis(b_c);
        r2 * cis(theta) + r3 * cis(a_b) == r1 + r4 * cis(c);
    }
}

#[test]
fn joined_names_stay_apart() {
    use joined_names::{Joined, JoinedAssembly};
    let joined = Joined {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let [open, crossed] = kin_core::Assembly::BOTH;
    let position = |first, second| {
        let assembly = JoinedAssembly {
            a_b_c: first,
            a_b_c_2: second,
        };
        joined.position(0.5, assembly).expect("it closes")
    };
    let pose = position(open, open);
    assert_eq!([pose.a, pose.b_c], [pose.a_b, pose.c]);
    let pose = position(open, crossed);
    assert!(pose.b_c.position() > 0.0 && pose.c.position() < 0.0);
}

/// A deprecated item warns its users, and not its own expansion.
#[deny(warnings)]
#[allow(missing_docs, missing_debug_implementations)]
mod deprecated_mechanism {
    kin_core::mechanism! {
        /// An engine.
        #[deprecated(note = "use another one")]
        pub struct Old {
            /// Crank.
            #[deprecated]
            pub r: Length,
            /// Rod.
            #[deprecated = "all rods are long"]
            pub l: Vector,
        }
        input theta: Angle;
        unknown phi: Angle, s: Length;
        r * cis(theta) + l * cis(phi) == vec2(s, 0);
        with sensitivities, transmission_angles, test;
    }
}

/// Attributes that depend on a condition, and one that does not.
mod conditional_attributes {
    kin_core::mechanism! {
        #[cfg_attr(all(), derive(PartialOrd))]
        #[must_use]
        pub struct Conditional {
            #[cfg_attr(any(), doc = "not here")]
            pub r: Length,
            pub l: Length,
        }
        input theta: Angle;
        unknown phi: Angle, s: Length;
        r * cis(theta) + l * cis(phi) == vec2(s, 0);
    }
}

#[test]
fn attributes_may_depend_on_conditions() {
    use conditional_attributes::Conditional;
    let one = Conditional { r: 1.0, l: 3.0 };
    let other = Conditional { r: 1.0, l: 4.0 };
    assert!(one < other);
}
