//! The content of a page, as data.
//!
//! Angles are in radians, lengths in the unit of the mechanism, rates per unit of time.

use std::collections::BTreeMap;

use kin_core::cycle::{Circuit, EndKind};
use serde::{Deserialize, Serialize};

/// The version of the format that this crate writes.
pub const FORMAT: u32 = 3;

/// A mechanism with its motion, its limits, its peaks and its equations: the whole content of a page.
///
/// [`Draft`](super::Draft) makes it, and [`Report::html`] writes the page. It holds numbers and texts alone, so that it
/// can be stored and read again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Report {
    /// The version of this format, [`FORMAT`].
    pub format: u32,
    /// The version of kin that made the report.
    pub kin: String,
    /// The title of the page.
    pub title: String,
    /// The name of the mechanism's structure.
    pub name: String,
    /// The same in small letters, for files: `four_bar`.
    pub module: String,
    /// The description of the mechanism; may be empty.
    pub documentation: String,
    /// The declaration as it was typed, if it is known.
    pub declaration: Option<String>,
    /// The SHA-256 of version, equations, declaration and dimensions, in hexadecimal digits.
    pub hash: String,
    /// The names of the units.
    pub units: Units,
    /// Whether angles are shown in degrees at first.
    pub degrees: bool,
    /// The highest time derivative.
    pub order: usize,
    /// The scalar parameters with their values.
    pub parameters: Vec<Quantity>,
    /// The inputs. Those that stand have their value, and those that move have none.
    pub inputs: Vec<Quantity>,
    /// The unknowns.
    pub unknowns: Vec<Quantity>,
    /// The scalar outputs; a point is its coordinates.
    pub outputs: Vec<Quantity>,
    /// The names of the quantities that are plotted at first.
    pub plots: Vec<String>,
    /// The index of the first input that moves.
    pub moving: usize,
    /// The motion of the inputs over the variable.
    pub drive: Drive,
    /// The range of the variable.
    pub range: [f64; 2],
    /// The way of the variable after which all positions repeat themselves, if the range closes.
    pub period: Option<f64>,
    /// The change of the variable for each unit of time: the speed of the moving input, or 1 if the variable is the
    /// time.
    pub speed: f64,
    /// The assemblies.
    pub assemblies: Vec<Assembly>,
    /// The index of the assembly that the page shows, and for which the numbers below hold.
    pub assembly: usize,
    /// Whether a block has no closed form, so that assemblies are chosen by values nearby.
    pub coupled: bool,
    /// Whether joints have three coordinates.
    pub space: bool,
    /// All circuits and branches over the moving input; none under laws, which lead along a curve.
    pub cycle: Option<Cycle>,
    /// The highest and the lowest value of each derivative of each unknown and output, over the range.
    pub extremes: Vec<Extreme>,
    /// The root mean squares over time, over the range.
    pub rms: Vec<RootMeanSquare>,
    /// The extremes and means that could not be found, with the reason.
    pub unanswered: Vec<Unanswered>,
    /// The transmission angles, if there is a dyad.
    pub transmission: Option<Transmission>,
    /// The dependence of the peaks on the dimensions.
    pub sensitivities: Vec<Sensitivity>,
    /// The equations.
    pub formulas: Formulas,
    /// The solutions of the blocks.
    pub blocks: Vec<Block>,
    /// The cost of each order.
    pub operations: Vec<Cost>,
    /// The position of the range at which the mechanism is furthest from closing, if it does not close everywhere.
    pub not_closed: Option<NotClosed>,
    /// The joints of the ground, of bodies and of slides.
    pub outline: Outline,
    /// The forces that loads cause, if there are loads.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub forces: Option<Forces>,
    /// The poses of the range, for a mechanism whose solver cannot be recorded.
    pub frames: Option<Vec<Frame>>,
    /// The solver as a JavaScript module, if it can be recorded. The page has it as a script, and not among its data.
    pub solver: Option<String>,
    /// The reason why there is no solver.
    pub unrecorded: Option<String>,
}

/// The names of the units.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Units {
    /// The unit of length; empty if it has no name.
    pub length: String,
    /// The unit of time.
    pub time: String,
}

/// The motion of the inputs: a function of one variable for each input.
///
/// In each piece of the range an input is a power series, whose derivatives with respect to the variable are exact
/// through snap, up to rounding. With respect to time, the derivative of order `k` is that with respect to the variable
/// times the `k`-th power of [`speed`](Report::speed).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drive {
    /// The variable over which the inputs move.
    pub variable: Variable,
    /// The pieces of the range, one after the other.
    pub pieces: Vec<Piece>,
    /// The values of the variable within the range at which the motion of an input is not smooth.
    pub joints: Vec<Joint>,
}

/// The variable over which the inputs move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Variable {
    /// The moving input: the others move in proportion, or stand.
    Input,
    /// The time: each input moves under a law.
    Time,
}

/// A piece of the range.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Piece {
    /// The first value of the variable.
    pub from: f64,
    /// The last value of the variable.
    pub to: f64,
    /// The value of the variable about which the series are.
    pub at: f64,
    /// For each input the coefficients of its series, from the constant term on.
    pub inputs: Vec<Vec<f64>>,
}

/// A value of the variable at which two pieces of a law meet and a derivative jumps.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Joint {
    /// The value of the variable.
    pub at: f64,
    /// The lowest order of a derivative that jumps.
    pub order: usize,
}

/// A quantity by its names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quantity {
    /// The name as declared.
    pub name: String,
    /// The name in the solver.
    pub key: String,
    /// The name as it is printed: θ₂.
    pub text: String,
    /// The first paragraph of the documentation.
    pub documentation: String,
    /// `length`, `angle` or `number`.
    pub dimension: Dimension,
    /// The value of a parameter, or of an input that stands still.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub value: Option<f64>,
}

/// A dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Dimension {
    /// A length.
    Length,
    /// An angle.
    Angle,
    /// A plain number.
    Number,
}

/// An assembly, with the argument by which the solver chooses it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Assembly {
    /// Its name.
    pub name: String,
    /// The argument of the solver.
    pub argument: Argument,
    /// The value of the variable at which the argument holds, for values nearby.
    pub at: Option<f64>,
    /// The index of its first circuit.
    pub circuit: Option<usize>,
}

/// The argument of the solver that chooses an assembly.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Argument {
    /// One choice: 1 for open, -1 for crossed; also for a mechanism without a choice.
    One(f64),
    /// Several choices, or values near the unknowns, by their names in the solver.
    Several(BTreeMap<String, f64>),
}

/// All circuits and branches.
///
/// A report keeps this part of a [`CycleData`](kin_core::cycle::CycleData), which can be written but not read again,
/// because it borrows the names of unknowns from the mechanism. A page needs no positions along branches, and has
/// another list of assemblies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cycle {
    /// The reasons why there may be other branches, each a clause; none if it is proved that there is no other branch.
    pub incomplete: Vec<String>,
    /// The circuits.
    pub circuits: Vec<Circuit>,
    /// The branches.
    pub branches: Vec<Branch>,
}

/// A branch: a part of a circuit over which the input moves in one direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Branch {
    /// The index of its circuit.
    pub circuit: usize,
    /// The index of its assembly among those of the report; none if it lies beyond the range.
    pub assembly: Option<usize>,
    /// The ends with the smallest and the largest input.
    pub ends: [End; 2],
}

/// An end of a branch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct End {
    /// The reason why the branch ends there.
    pub kind: EndKind,
    /// The input there.
    pub input: f64,
    /// The unknowns of the block that is singular there; empty if there is none.
    pub block: String,
}

/// A highest or a lowest value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Extreme {
    /// The name of the unknown or output.
    pub quantity: String,
    /// The quantity and its order in words.
    pub text: String,
    /// The order of the derivative.
    pub order: usize,
    /// Whether it is the highest or the lowest value.
    pub kind: Side,
    /// The value, or nothing if the quantity grows beyond all bounds there.
    pub value: Option<f64>,
    /// The value of the variable.
    pub at: f64,
    /// The reason why the value is extreme.
    #[serde(rename = "place")]
    pub cause: Cause,
}

/// The side of an extreme.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// The highest value.
    Highest,
    /// The lowest value.
    Lowest,
}

/// The reason why a value is extreme.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Cause {
    /// The slope vanishes.
    Inner,
    /// The mechanism closes no further.
    Limit,
    /// The quantity has a kink.
    Kink,
    /// The range ends.
    End,
    /// The quantity grows beyond all bounds.
    Unbounded,
}

/// A root mean square over time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RootMeanSquare {
    /// The name of the unknown or output.
    pub quantity: String,
    /// The order of the derivative.
    pub order: usize,
    /// The value, or nothing if the integral diverges at a limit.
    pub value: Option<f64>,
}

/// An extreme or a mean that could not be found.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Unanswered {
    /// The name of the unknown or output.
    pub quantity: String,
    /// The order of the derivative.
    pub order: usize,
    /// The reason.
    pub text: String,
}

/// Transmission angles over the range, each the smaller of the angle and its supplement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Transmission {
    /// The unknowns of each dyad.
    pub dyads: Vec<String>,
    /// The smallest angle of each dyad, and the variable there.
    pub worst: Vec<WorstAngle>,
    /// The angles of all dyads over the range, to nine figures.
    pub samples: Vec<Angles>,
}

/// The smallest transmission angle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorstAngle {
    /// The angle, 0 at a limit.
    pub angle: f64,
    /// The variable there.
    pub at: f64,
}

/// The transmission angles at one value of the variable.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Angles {
    /// The variable.
    pub input: f64,
    /// An angle for each dyad.
    pub angles: Vec<f64>,
}

/// The dependence of a peak on the dimensions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sensitivity {
    /// The name of the unknown or output.
    pub quantity: String,
    /// The peak in words.
    pub text: String,
    /// The order of the derivative.
    pub order: usize,
    /// The value that is largest in size, with its sign.
    pub peak: f64,
    /// The variable there.
    pub at: f64,
    /// The derivative of the peak with respect to each parameter.
    pub values: Vec<f64>,
}

/// The equations and their solution.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Formulas {
    /// The equations.
    pub closure: Formula,
    /// The solution of each block.
    pub position: Vec<Formula>,
    /// The linear equations of each block's velocities.
    pub velocity: Vec<Formula>,
    /// The linear equations of all higher orders.
    pub rates: Formula,
    /// The outputs.
    pub outputs: Formula,
}

/// A formula in two forms.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Formula {
    /// As text.
    pub text: String,
    /// As MathML.
    pub mathml: String,
}

/// The solution of a block.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Block {
    /// Its unknowns.
    pub unknowns: String,
    /// The method.
    pub solution: String,
}

/// The cost of an order.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Cost {
    /// The order.
    pub order: usize,
    /// Additions, multiplications, divisions and changes of sign.
    pub total: usize,
    /// The cost in words.
    pub text: String,
}

/// A position at which the mechanism does not close.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NotClosed {
    /// The reason in words.
    pub text: String,
    /// The unknowns of the block at fault.
    pub unknowns: String,
    /// The missing length as a negative number, if the links do not reach.
    pub margin: Option<f64>,
    /// The variable there.
    pub at: f64,
}

/// The joints of the ground, of bodies and of slides, by their indices.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Outline {
    /// The joints that stand still.
    pub ground: Vec<usize>,
    /// The bodies that move.
    pub bodies: Vec<Body>,
    /// The joints that slide along a line.
    pub slides: Vec<Slide>,
    /// The marked points.
    pub points: Vec<Point>,
}

/// A body that moves.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Its joints.
    pub joints: Vec<usize>,
}

/// A joint that slides along a line.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Slide {
    /// The joint.
    pub joint: usize,
    /// The body that carries the line; nothing if the line stands still.
    pub guide: Option<usize>,
}

/// A marked point.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Point {
    /// Its name.
    pub name: String,
    /// Its joint.
    pub joint: usize,
}

/// The forces in joints, and the efforts of drives, in N and N m.
///
/// They hold for the dimensions, the speed and the assembly of the report.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Forces {
    /// The metres of the unit of lengths.
    pub metres: f64,
    /// The forces in joints; none if the declaration does not state its bodies.
    pub joints: Vec<JointForce>,
    /// The efforts of drives and the moments of guides.
    pub curves: Vec<ForceCurve>,
    /// What acts on the bodies beside the joints.
    pub body_loads: Vec<BodyLoad>,
    /// The pitch curves of gears and racks of the plane.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<Contact>,
    /// All of them over the range, in the order of the variable.
    pub samples: Vec<ForceSample>,
    /// The mean powers over time, if joints have friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub powers: Option<MeanPowers>,
    /// Why some or all forces in joints are not known.
    pub unknown: Option<String>,
}

/// The pitch curves of two bodies that roll on each other: two circles, or one and the line of a rack.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// The pitch circles.
    pub circles: Vec<PitchCircle>,
    /// The line of a rack whose direction is given by numbers.
    pub rack: Option<PitchLine>,
}

/// The pitch circle of a gear.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PitchCircle {
    /// The index of its body; nothing for the ground.
    pub body: Option<usize>,
    /// Its centre.
    pub centre: Place,
    /// Its radius.
    pub radius: f64,
    /// The name of the dimension that is its radius.
    pub dimension: Option<String>,
}

/// The pitch line of a rack.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PitchLine {
    /// The index of its body; nothing for the ground.
    pub body: Option<usize>,
    /// Its direction, of any length.
    pub along: [f64; 2],
}

/// A point of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Place {
    /// A joint, by its index.
    Joint(usize),
    /// A point of the ground, by its coordinates.
    Fixed([f64; 2]),
}

/// What drives give and friction takes in the mean over time, in W.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeanPowers {
    /// The power of all drives.
    pub input: f64,
    /// The power that friction turns into heat.
    pub heat: f64,
    /// The efficiency; nothing if friction locks the mechanism, or if nothing has power.
    pub efficiency: Option<f64>,
}

/// The force in a joint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JointForce {
    /// Its name.
    pub name: String,
    /// The index of the body on which it acts; nothing for the ground.
    pub on: Option<usize>,
    /// The index of the body that exerts it; nothing for the ground.
    pub by: Option<usize>,
    /// The index of the joint; nothing for a contact in which bodies roll on each other.
    pub joint: Option<usize>,
    /// Whether it is the force of a guide.
    pub is_slide: bool,
    /// The size of the force over the range, if it is known.
    pub peak: Option<ForcePeak>,
}

/// The effort of a drive or the moment of a guide.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ForceCurve {
    /// Its name as a column.
    pub name: String,
    /// Its name in words.
    pub text: String,
    /// What it is.
    pub kind: CurveKind,
    /// Its values over the range, if they are known.
    pub peak: Option<ForcePeak>,
}

/// A force or a moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum CurveKind {
    /// A force in N.
    Force,
    /// A moment in N m.
    Moment,
}

/// A force over the range.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ForcePeak {
    /// The value that is largest in size, or nothing if it grows beyond all bounds.
    pub value: Option<f64>,
    /// The value of the variable there.
    pub at: f64,
    /// The root of the mean square over time.
    pub rms: Option<f64>,
    /// The rate by time that is largest in size.
    pub rate: Option<f64>,
}

/// A force or a couple on a body beside its joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct BodyLoad {
    /// The index of the body.
    pub body: usize,
    /// What exerts it.
    pub kind: ActingLoad,
    /// Whether it is a couple.
    pub is_couple: bool,
}

/// What exerts a force on a body beside its joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ActingLoad {
    /// A mass, by its weight and its resistance to acceleration.
    Mass,
    /// A force, a torque, a spring or a damper.
    Load,
    /// A drive.
    Drive,
    /// The friction in a pin.
    Friction,
    /// A guide, which keeps the body from turning.
    Guide,
}

/// The forces at one place of the range, to six figures.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ForceSample {
    /// The variable.
    pub input: f64,
    /// For each joint the components of the force and their rates by time; nothing where it is not known.
    pub forces: Vec<Option<[f64; 4]>>,
    /// For each curve its value and its rate.
    pub curves: Vec<Option<[f64; 2]>>,
    /// For each load on a body the moment of the couple, or the force and the place where it acts. Empty where they are
    /// not known.
    pub loads: Vec<Vec<f64>>,
    /// For each joint without an index the place where its force acts. Empty where they are not known.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<[f64; 2]>,
}

/// A pose, as the solver would find it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Frame {
    /// The variable.
    pub input: f64,
    /// The unknowns and then the outputs, each with its rates. It is empty where the mechanism does not close.
    pub values: Vec<Vec<f64>>,
    /// The joints.
    pub joints: Vec<Vec<f64>>,
    /// The directions of the slides.
    pub slides: Vec<Vec<f64>>,
}
