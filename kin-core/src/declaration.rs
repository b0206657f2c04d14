//! The macro, which hands a declaration to its machinery with the path of this crate.

/// Declares a mechanism by its loop closure, and generates solvers for its position and all time derivatives up to snap
/// (also called jounce), or up to another order.
///
/// `use kin_core::prelude::*;` imports the macro together with what its solvers take, `Motion` and `Assembly` among
/// others.
///
/// A declaration is a structure with the dimensions of the mechanism, and statements in any order:
///
/// ```text
/// declaration = struct statement*
/// struct      = attribute* visibility "struct" NAME "{" field ("," field)* "}"
/// field       = attribute* visibility NAME ":" dimension
/// dimension   = "Length" | "Angle" | "Scalar" | "Point" | "Vector" | "Point3" | "Vector3"
///
/// statement   = "input"   quantity ("," quantity)* ";"
///             | "unknown" unknown  ("," unknown)* ";"
///             | "order" "=" INTEGER ";"
///             | "with" request ("," request)* ";"
///             | "for" names "in" "[" element ("," element)* "]" "{" repeatable+ "}"
///             | repeatable
/// repeatable  = "let" NAME "=" (expression | frame) ";"
///             | "output" NAME ":" dimension "=" expression ";"
///             | expression "==" expression ";"
///             | "body" NAME ":" points ";"
///             | "ground" points ";"
///             | "slide" expression "along" expression ("on" NAME)? ";"
/// frame       = "frame" "(" expression "," expression ")"
/// names       = NAME | "(" NAME ("," NAME)* ")"
/// element     = expression | "(" expression ("," expression)* ")"
/// points      = expression ("," expression)*
/// request     = "transmission_angles" | "sensitivities" | "test"
/// quantity    = NAME ":" ("Length" | "Angle" | "Scalar")
/// unknown     = NAME ":" ("Length" | "Angle" | "Scalar" | "Direction") range?
/// range       = "where" NAME ("<" | "<=" | ">" | ">=") constant
///             | "in" constant (".." | "..=") constant
/// ```
///
/// - Each field of the structure has a `dimension`. The structure becomes generic over its number type, which is `f64`
///   by default. Documentation, other attributes and visibility are passed on.
/// - An equation joins two scalars, two plane vectors or two space vectors, and counts as one, two or three scalar
///   equations. There are as many scalar equations as unknowns.
/// - An unknown declared as a `Direction` is an angle whose cosine and sine are wanted: the result is a [`Direction`],
///   without an arctangent.
/// - A range selects one of two solutions. For unknowns without a range, an [`Assembly`] selects it.
/// - The order is the highest time derivative, from 1 to 12. The default is 4, which is snap. After snap come crackle
///   and pop, then `derivative_7` and so on.
/// - `with` requests more generated items. For example, `with transmission_angles;` requests the method that returns
///   the [`TransmissionAngle`] of every dyad. `with sensitivities;` requests the method `sensitivities`, which returns
///   the partial derivatives of unknowns and outputs, and of all their time derivatives, with respect to each
///   parameter: see [`Sensitive`].
/// - `body`, `ground` and `slide` state for the [`Skeleton`] what belongs together, where the equations do not.
/// - `for` repeats statements with other names. A `frame` is the origin and the rotation, in the plane the angle, of a
///   rigid body, whose points are placed by `frame * point`.
/// - A `let` is an abbreviation; it must precede its uses. An output is a quantity that is calculated to the same order
///   as the unknowns. Formulas behind it may use it as they use a `let`.
///
/// Expressions are Rust expressions of the declared names, numbers and `PI`, with `+`, `-`, `*`, `/`, with `sin`,
/// `cos`, `tan`, `asin`, `acos`, `atan`, `atan2`, `sinh`, `cosh`, `tanh`, `asinh`, `acosh`, `atanh`, `sqrt`, `exp`,
/// `ln` and `powi`, and with three functions that make plane vectors: `cis(angle)`, the unit vector at an angle,
/// `polar(length, angle)`, and `vec2(x, y)`. Functions may be written as methods, and the coordinates of a vector `v`
/// are `v.x` and `v.y`. Plane vectors multiply like complex numbers, so `v * cis(angle)` is `v` rotated by the angle. A
/// scalar that is added to a vector lies along the x axis.
///
/// The function `vec3(x, y, z)` makes space vectors, whose coordinates are `v.x`, `v.y` and `v.z`. Rotations rotate
/// them: `rotation * vector`. A rotation is `rot_x(angle)`, `rot_y(angle)`, `rot_z(angle)`, `rot(axis, angle)` about an
/// axis of any length but zero, or a product of rotations, of which the last one rotates first. Plane and space vectors
/// both have `dot(a, b)`, `cross(a, b)` (a scalar in the plane) and `norm(v)`. Plane and space do not mix:
/// `vec3(v.x, v.y, 0)` places a plane vector in space, and `vec3(s, 0, 0)` a scalar.
///
/// Angles are in radians. Dimensions are checked: a length plus an angle, the sine of a length, and a scalar equal to a
/// vector do not compile. The product of a length and an angle is a length.
///
/// ```
/// use kin_core::prelude::*;
///
/// mechanism! {
///     /// Planar four-bar linkage: ground 1, crank 2, coupler 3, rocker 4.
///     pub struct FourBar {
///         /// From the pivot of the crank to the pivot of the rocker.
///         pub r1: Length,
///         /// Crank.
///         pub r2: Length,
///         /// Coupler.
///         pub r3: Length,
///         /// Rocker.
///         pub r4: Length,
///     }
///     input theta2: Angle;
///     unknown theta3: Angle, theta4: Angle;
///
///     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
///
///     let half = r3 / 2;
///     output midpoint: Point = r2 * cis(theta2) + half * cis(theta3);
/// }
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let crank = Motion::from([65f64.to_radians(), -10.0, 2.0, -0.5, 0.3]);
///
/// // everything through snap in one call
/// let pose = linkage.solve(crank, Assembly::Open)?;
/// println!("{} {:?}", pose.theta4.snap(), pose.midpoint.acceleration());
///
/// // or successively: each solver takes what its order adds, and reuses what came before
/// let position = linkage.position(crank.value(), Assembly::Open)?;
/// let velocity = position.velocity(crank.velocity());
/// let acceleration = velocity.acceleration(crank.acceleration());
/// let jerk = acceleration.jerk(crank.jerk());
/// let snap = jerk.snap(crank.snap());
/// # Ok::<(), SolveError>(())
/// ```
///
/// A declaration up to the sixth derivative:
///
/// ```
/// use kin_core::prelude::*;
///
/// mechanism! {
///     /// A point on a wheel.
///     pub struct Wheel {
///         /// Its distance from the axle.
///         pub radius: Length,
///     }
///     input theta: Angle;
///     unknown height: Length;
///     height == radius * sin(theta);
///     order = 6;
/// }
///
/// let wheel = Wheel { radius: 2.0 };
/// let pose: WheelPop = wheel.solve(Motion::at_constant_speed(0.5, 3.0))?;
/// assert!((pose.height.crackle() - 2.0 * 243.0 * 0.5_f64.cos()).abs() < 1e-12);
/// assert!((pose.height.pop() + 2.0 * 729.0 * 0.5_f64.sin()).abs() < 1e-12);
/// # Ok::<(), SolveError>(())
/// ```
///
/// [`Direction`]: crate::Direction
/// [`Assembly`]: crate::Assembly
/// [`TransmissionAngle`]: crate::TransmissionAngle
/// [`Sensitive`]: crate::Sensitive
/// [`Skeleton`]: crate::Skeleton
#[macro_export]
macro_rules! mechanism {
    ($($declaration:tt)*) => {
        $crate::__private::mechanism_in! { ($crate) $($declaration)* }
    };
}
