//! The wishes for a report, one after the other.

use std::fmt;
use std::marker::PhantomData;
use std::ops::RangeInclusive;
use std::path::Path;

use kin_core::any::{AssemblyChoice, Named, Of};
use kin_core::law::Piecewise;
use kin_core::linkage::AnyLinkage;
use kin_core::load::NamedLoads;
use kin_core::{ClosedRange, Mechanism};

use super::functions::ReportFunctions;
use super::model::Report;
use super::{ReportError, gather};
use crate::forces::Stated;

/// A report that is to be made: a mechanism, and what is wanted beside the defaults. [`report`](super::report) begins
/// it.
#[derive(Clone, Debug)]
#[must_use = "write it, or ask for its `report`"]
pub struct Draft<'l, M> {
    wishes: Wishes<'l>,
    mechanism: PhantomData<M>,
}

/// A mechanism without a type, which stands for the type in a [`Draft`].
#[derive(Clone, Copy, Debug)]
pub struct Untyped;

/// A draft without the type of its mechanism.
#[derive(Clone, Debug)]
pub(crate) struct Wishes<'l> {
    pub(crate) functions: &'l dyn ReportFunctions,
    pub(crate) linkage: AnyLinkage<'l>,
    pub(crate) assembly: Option<AssemblyChoice>,
    pub(crate) way: WayWished<'l>,
    /// The values of the inputs that do not move.
    pub(crate) at: Option<Vec<f64>>,
    pub(crate) moving: Option<String>,
    pub(crate) range: Option<[f64; 2]>,
    pub(crate) speed: Option<f64>,
    pub(crate) plots: Vec<String>,
    pub(crate) title: Option<String>,
    pub(crate) documentation: String,
    pub(crate) declaration: Option<String>,
    pub(crate) length: String,
    pub(crate) time: String,
    pub(crate) degrees: bool,
    pub(crate) loads: Option<WishedLoads>,
    /// Whether peaks and means are found, which takes most of the time.
    pub(crate) has_peaks: bool,
}

/// Loads, and the metres of the unit of lengths.
#[derive(Clone, Debug)]
pub(crate) struct WishedLoads {
    pub(crate) loads: NamedLoads,
    pub(crate) stated: Stated,
    pub(crate) metres: f64,
}

/// The motion of the inputs.
#[derive(Clone, Default)]
pub(crate) enum WayWished<'l> {
    /// One input moves, at a constant speed, through a range.
    #[default]
    OneInput,
    /// All inputs move, along the straight line between two points.
    Between([Vec<f64>; 2]),
    /// All inputs move, each under a law, over a range of the time.
    UnderLaws(Vec<&'l dyn Piecewise<f64>>, [f64; 2]),
}

/// Not derived: laws are functions, which cannot be printed.
impl fmt::Debug for WayWished<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OneInput => formatter.write_str("OneInput"),
            Self::Between(ends) => formatter.debug_tuple("Between").field(ends).finish(),
            Self::UnderLaws(laws, range) => write!(formatter, "UnderLaws({}, {range:?})", laws.len()),
        }
    }
}

impl<'l> Wishes<'l> {
    /// No wishes beside the mechanism.
    pub(crate) fn new(functions: &'l dyn ReportFunctions, parameters: &[f64]) -> Self {
        Self {
            functions,
            linkage: AnyLinkage::new(functions, parameters),
            assembly: None,
            way: WayWished::OneInput,
            at: None,
            moving: None,
            range: None,
            speed: None,
            plots: Vec::new(),
            title: None,
            documentation: String::new(),
            declaration: None,
            length: String::new(),
            time: "s".to_owned(),
            degrees: true,
            loads: None,
            has_peaks: true,
        }
    }

    pub(crate) fn report(&self) -> Result<Report, ReportError> {
        gather::report(self)
    }

    /// A text of kin-core with the names of the mechanism instead of their indices.
    pub(super) fn named(&self, text: impl fmt::Display) -> String {
        Named::new(text, self.linkage.description()).to_string()
    }
}

impl<'l, M: Mechanism<Scalar = f64>> Draft<'l, M> {
    pub(super) fn new(mechanism: &M) -> Self {
        Self {
            wishes: Wishes::new(Of::<M>::FUNCTIONS, mechanism.parameters().as_ref()),
            mechanism: PhantomData,
        }
    }

    /// The assembly that is shown first; otherwise the first that closes. [`Near`](kin_core::Near) values hold at the
    /// inputs of [`at`](Self::at), or where the line of [`between`](Self::between) or the laws begin.
    pub fn assembly(mut self, assembly: M::Assembly) -> Self {
        self.wishes.assembly = Some(AssemblyChoice::of::<M>(assembly));
        self
    }

    /// The values of the inputs that do not move, and at which values nearby hold; otherwise zero.
    pub fn at(mut self, inputs: M::Inputs<f64>) -> Self {
        self.wishes.at = Some(inputs.as_ref().to_vec());
        self
    }

    /// All inputs move together, along the straight line between two points in the space of the inputs. The variable of
    /// the page is the first input that moves, as for a [sweep](kin_core::sweep::Assembled::between).
    ///
    /// ```
    /// use kin_core::library::FiveBar;
    ///
    /// let robot = FiveBar { ground: 2.0, left: 0.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
    /// let page = kin_studio::report(&robot).between([0.0, 1.0], [2.0, 1.6]).speed(3.0).report()?;
    /// assert_eq!((page.range, page.speed), ([0.0, 2.0], 3.0));
    /// # Ok::<(), kin_studio::report::ReportError>(())
    /// ```
    pub fn between(mut self, from: M::Inputs<f64>, to: M::Inputs<f64>) -> Self {
        self.wishes.way = WayWished::Between([from, to].map(|inputs| inputs.as_ref().to_vec()));
        self
    }

    /// Each input moves under a [motion law](kin_core::law), in brackets, over a range of the time, as for a
    /// [sweep](kin_core::sweep::Assembled::under_laws). The variable of the page is the time. An input that stands
    /// takes a [`Dwell`](kin_core::law::Dwell).
    ///
    /// ```
    /// use kin_core::law::{Dwell, Rise, Sequence, Shape};
    /// use kin_core::library::SliderCrank;
    ///
    /// // the servo turns the crank by 90 degrees in 0.4 s, and waits for 0.1 s
    /// let rise = Rise::new(Shape::ModifiedSine, 0.0, 90_f64.to_radians(), 0.4)?;
    /// let dwell = Dwell::new(90_f64.to_radians(), 0.1)?;
    /// let servo = Sequence::new([&rise, &dwell])?;
    /// let press = SliderCrank { r: 0.1, l: 0.3 };
    /// let page = kin_studio::report(&press).under_laws([&servo], 0.0..=0.5).report()?;
    /// // the jerk of a modified sine jumps at its end, and its snap within
    /// let joints: Vec<_> = page.drive.joints.iter().map(|joint| joint.order).collect();
    /// assert_eq!(joints, [4, 4, 3]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn under_laws(mut self, laws: M::Inputs<&'l dyn Piecewise<f64>>, range: impl ClosedRange) -> Self {
        self.wishes.way = WayWished::UnderLaws(laws.as_ref().to_vec(), range.ends());
        self
    }
}

impl<'l> Draft<'l, Untyped> {
    pub(super) fn of(functions: &'l dyn ReportFunctions, parameters: &[f64]) -> Self {
        Self {
            wishes: Wishes::new(functions, parameters),
            mechanism: PhantomData,
        }
    }

    /// The assembly that is shown first, by its index; otherwise the first that closes.
    pub fn assembly(mut self, index: usize) -> Self {
        self.wishes.assembly = Some(AssemblyChoice::Index(index));
        self
    }

    /// The values of the inputs that do not move; otherwise zero.
    pub fn at(mut self, inputs: &[f64]) -> Self {
        self.wishes.at = Some(inputs.to_vec());
        self
    }
}

impl<M> Draft<'_, M> {
    /// The input that moves, by its name; otherwise the first.
    pub fn moving(mut self, input: impl Into<String>) -> Self {
        self.wishes.moving = Some(input.into());
        self
    }

    /// The range of the moving input; otherwise as far as the mechanism closes.
    pub fn range(mut self, range: RangeInclusive<f64>) -> Self {
        self.wishes.range = Some([*range.start(), *range.end()]);
        self
    }

    /// The speed of the moving input, or of the first input that moves along the line of [`between`](Self::between);
    /// otherwise 1, so that rates are per unit of the input.
    pub fn speed(mut self, speed: f64) -> Self {
        self.wishes.speed = Some(speed);
        self
    }

    /// The unknowns and outputs that are plotted at first, by their names; otherwise all.
    pub fn plots<N: Into<String>>(mut self, names: impl IntoIterator<Item = N>) -> Self {
        self.wishes.plots = names.into_iter().map(Into::into).collect();
        self
    }

    /// The title; otherwise the name of the mechanism.
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.wishes.title = Some(title.into());
        self
    }

    /// The description of the mechanism, in a few sentences.
    pub fn documentation(mut self, text: impl Into<String>) -> Self {
        self.wishes.documentation = text.into();
        self
    }

    /// The declaration as it was typed, to be shown on the page.
    pub fn declaration(mut self, text: impl Into<String>) -> Self {
        self.wishes.declaration = Some(text.into());
        self
    }

    /// The names of the units of length and time; otherwise a length without a name, and seconds.
    pub fn units(mut self, length: impl Into<String>, time: impl Into<String>) -> Self {
        (self.wishes.length, self.wishes.time) = (length.into(), time.into());
        self
    }

    /// The loads whose forces are shown: in the joints, if the declaration states its bodies, and of the drives. Masses
    /// are in kilograms, the time is in seconds, and the unit of lengths has so many metres. Forces are shown in
    /// newtons.
    ///
    /// ```
    /// use kin_core::linkage::AnyLinkage;
    /// use kin_core::prelude::*;
    ///
    /// mechanism! {
    ///     /// Slider-crank in millimetres.
    ///     pub struct Pump { pub r: Length, pub l: Length }
    ///     input theta: Angle;
    ///     unknown phi: Angle, s: Length;
    ///     r * cis(theta) + l * cis(phi) == vec2(s, 0);
    ///     output pin: Point = r * cis(theta);
    ///     output piston: Point = vec2(s, 0);
    ///     ground 0;
    ///     body crank: 0, pin;
    ///     body rod: pin, piston;
    ///     slide piston along vec2(1, 0);
    /// }
    ///
    /// let pump = Pump { r: 50.0, l: 150.0 };
    /// let loads = AnyLinkage::of(&pump).loads().mass(0.8, "piston")?;
    /// let page = kin_studio::report(&pump).speed(rpm(900.0)).units("mm", "s").loads(&loads, 0.001).report()?;
    /// let forces = page.forces.ok_or("no forces")?;
    /// // the piston is slowed down and sped up by r ω² (1 + r / l) at most
    /// let peak = forces.joints.iter().find(|joint| joint.name == "pin").and_then(|pin| pin.peak);
    /// let expected = 0.8 * 0.05 * rpm(900.0).powi(2) * (1.0 + 50.0 / 150.0);
    /// assert!((peak.and_then(|peak| peak.value).ok_or("no peak")? - expected).abs() < 1e-9 * expected);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn loads(mut self, loads: &NamedLoads, metres: f64) -> Self {
        let loads = loads.clone();
        self.wishes.loads = Some(WishedLoads {
            loads,
            stated: Stated::default(),
            metres,
        });
        self
    }

    /// Angles in radians at first, instead of degrees.
    pub fn in_radians(mut self) -> Self {
        self.wishes.degrees = false;
        self
    }

    /// The report.
    ///
    /// # Errors
    /// [`ReportError`] if the mechanism closes nowhere, if a number is not finite, if there is no such name, or if the
    /// inputs cannot move so.
    pub fn report(&self) -> Result<Report, ReportError> {
        self.wishes.report()
    }

    /// The page.
    ///
    /// # Errors
    /// As for [`report`](Self::report).
    pub fn html(&self) -> Result<String, ReportError> {
        Ok(self.report()?.html())
    }

    /// Writes the page to a file.
    ///
    /// # Errors
    /// As for [`report`](Self::report), and [`ReportError::File`].
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), ReportError> {
        self.report()?.write(path)
    }
}
