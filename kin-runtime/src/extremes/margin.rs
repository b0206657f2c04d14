//! The length that is left until a dyad ceases to close.

use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::{FRAC_PI_2, PI};

use super::ExtremesError;
use super::station::SweepStation;
use crate::any::{AnyMechanism, ClosureOver, FormsOver, TransmissionOver};
use crate::failure::SolveError;
use crate::mechanism::{Block, BlockForm, Description};
use crate::number::Number;
use crate::picture::TransmissionAngle;
use crate::quantity::{Dimension, NameKind};
use crate::sweep::Local;

/// What margins and transmission angles need of a mechanism.
pub trait DyadFunctions: AnyMechanism + ClosureOver<Local> + TransmissionOver<Local> + FormsOver<Local> {}

impl<F: AnyMechanism + ClosureOver<Local> + TransmissionOver<Local> + FormsOver<Local>> DyadFunctions for F {}

/// A position in series, from which margins and transmission angles are found.
pub(super) struct Margins<'f> {
    pub(super) functions: &'f dyn DyadFunctions,
    pub(super) description: &'f Description<'f>,
    pub(super) parameters: Vec<Local>,
    pub(super) inputs: Vec<Local>,
    pub(super) unknowns: Vec<Local>,
}

impl Margins<'_> {
    fn angles(&self) -> Vec<TransmissionAngle<Local>> {
        let none = TransmissionAngle::of("", Local::constant(0.0), Local::constant(1.0));
        let mut angles = vec![none; self.functions.dyad_count()];
        self.functions
            .angles_of_dyads(&self.parameters, &self.inputs, &self.unknowns, &mut angles);
        angles
    }

    /// The transmission angle of a dyad.
    pub(super) fn transmission_angle(&self, dyad: usize) -> Option<TransmissionAngle<Local>> {
        self.angles().get(dyad).copied()
    }

    /// The margin of a dyad.
    pub(super) fn of(&self, dyad: usize) -> Option<Local> {
        let transmission = self.transmission_angle(dyad)?;
        let (_, cosine) = transmission.angle.sin_cos();
        let mut forms = Vec::new();
        self.functions
            .block_forms(&self.parameters, &mut |form| forms.push(form));
        // a slider along an axis is a separate block behind that of its link
        let name = transmission.block;
        let is_own = |index: usize, block: &Block<'_>| match (name.text(), name.index()) {
            (Some(text), _) => name == block.unknowns || text.split(", ").any(|unknown| unknown == block.unknowns),
            (None, index_of_block) => index_of_block == Some((NameKind::Block, index)),
        };
        let mut blocks = self.description.blocks.iter().zip(&forms).enumerate();
        blocks.find_map(|(index, (block, form))| match form {
            _ if !is_own(index, block) => None,
            BlockForm::TwoLinks { lengths } if lengths.iter().any(Option::is_none) => self.slack(block),
            BlockForm::LinkAndSlider { length: None } => margin_of(
                &BlockForm::LinkAndSlider {
                    length: self.link(block),
                },
                cosine,
            ),
            _ => margin_of(form, cosine),
        })
    }

    /// What the equations of a block have left if some of its angles are changed.
    fn changed(&self, block: &Block<'_>, angles: &[(usize, f64)]) -> [Local; 2] {
        let mut unknowns = self.unknowns.clone();
        for (unknown, angle) in angles {
            unknowns[*unknown] = unknowns[*unknown] + Local::constant(*angle);
        }
        let mut residuals = vec![Local::constant(0.0); unknowns.len()];
        self.functions
            .closure(&self.parameters, &self.inputs, &unknowns, &mut residuals);
        let mut equations = block.equations.iter();
        [(); 2].map(|()| {
            equations
                .next()
                .map_or(Local::constant(0.0), |equation| residuals[*equation])
        })
    }

    /// The margin of two links by the sides of their triangle: what two sides are longer than the third one, at least.
    ///
    /// A link that is rotated by half a revolution changes the closure by twice its vector. One angle, the other one
    /// and both rotate the links one by one or together, which side ever belongs to which: an angle may be that of a
    /// link against the other link.
    fn slack(&self, block: &Block<'_>) -> Option<Local> {
        let &[one, other] = block.members else { return None };
        let [one, other] = [one, other].map(|unknown| (unknown, PI));
        let here = self.changed(block, &[]);
        let side = |angles: &[(usize, f64)]| {
            let [x, y] = self.changed(block, angles);
            length(half(x - here[0]), half(y - here[1]))
        };
        let [a, b, c] = [side(&[one])?, side(&[other])?, side(&[one, other])?];
        let slacks = [a + b - c, b + c - a, c + a - b];
        slacks
            .into_iter()
            .min_by(|one, other| one.real().total_cmp(&other.real()))
    }

    /// The length of the link of a slider.
    ///
    /// One equation of the slider on an axis gives the component of the link along the other axis. The other component
    /// is that of the link rotated by a right angle.
    fn link(&self, block: &Block<'_>) -> Option<Local> {
        let is_angle = |unknown: &usize| self.description.unknowns[*unknown].dimension == Dimension::Angle;
        let angle = block.members.iter().copied().find(is_angle)?;
        let [here, opposite, left, right] =
            [0.0, PI, FRAC_PI_2, -FRAC_PI_2].map(|change| self.changed(block, &[(angle, change)]));
        if let [_] = block.equations {
            return length(half(here[0] - opposite[0]), half(left[0] - right[0]));
        }
        length(half(here[0] - opposite[0]), half(here[1] - opposite[1]))
    }
    /// The smallest margin of all dyads.
    pub(super) fn smallest(&self) -> Option<Local> {
        let count = self.angles().len();
        let mut least = self.of(0)?;
        for dyad in 1..count {
            let margin = self.of(dyad)?;
            if margin.real() < least.real() {
                least = margin;
            }
        }
        Some(least)
    }
}

/// The transmission angle of a dyad at a point of a sweep.
pub(super) fn transmission_angle(
    margins: Result<Margins<'_>, SolveError>,
    station: &SweepStation<'_>,
    dyad: usize,
) -> Result<TransmissionAngle<Local>, ExtremesError> {
    let angle = margins.ok().and_then(|margins| margins.transmission_angle(dyad));
    angle.ok_or(ExtremesError::Gap {
        at: station.variable.real(),
    })
}

fn half(value: Local) -> Local {
    Local::constant(0.5) * value
}

/// The length of a vector, if it has a direction.
fn length(x: Local, y: Local) -> Option<Local> {
    let square = x * x + y * y;
    (square.real() > 0.0).then(|| square.sqrt())
}

/// The margin of a dyad with the cosine of its transmission angle.
fn margin_of(form: &BlockForm<Local>, cosine: Local) -> Option<Local> {
    let size = |value: Local| if value.real() < 0.0 { -value } else { value };
    match *form {
        BlockForm::FourBar {
            coupler: a, rocker: b, ..
        }
        | BlockForm::TwoLinks {
            lengths: [Some(a), Some(b)],
        } => {
            // the law of cosines
            let distance = (a * a + b * b - Local::constant(2.0) * a * b * cosine).sqrt();
            let [far, near] = [a + b - distance, distance - size(a - b)];
            Some(if near.real() < far.real() { near } else { far })
        }
        BlockForm::SliderCrank { coupler: link, .. } | BlockForm::LinkAndSlider { length: Some(link) } => {
            Some(link - size(link * cosine))
        }
        _ => None,
    }
}
