//! Labels of blocks that are shaped like a four-bar, derived from the lengths of their links.

use crate::mechanism::BlockForm;

/// The size of a difference that is rounding, in units of the sum of the lengths.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Whether a difference is positive, negative or zero up to rounding.
fn sign(difference: f64, size: f64) -> core::cmp::Ordering {
    if difference.abs() <= ROUNDING * size {
        core::cmp::Ordering::Equal
    } else {
        difference.total_cmp(&0.0)
    }
}

/// Grashof's types: whether the shortest link makes full revolutions relative to the others.
///
/// F. Grashof, *Theoretische Maschinenlehre* 2, 1883: it does if the shortest and the longest link together are shorter
/// than the other two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GrashofType {
    /// The shortest link makes full revolutions.
    Grashof,
    /// Both sums are equal: all links can come to lie on one line.
    ChangePoint,
    /// No link makes full revolutions relative to another one.
    NonGrashof,
}

/// Barker's classes of four-bar linkages.
///
/// C. R. Barker, *A complete classification of planar four-bar linkages*, Mechanism and Machine Theory 20 (1985),
/// 535-554. His symbols say what crank, coupler and rocker do relative to the ground: C makes full revolutions, R
/// swings; G stands for Grashof, R for the other ones with the number of the longest link, S for a change point, X for
/// two or four equal pairs.
///
/// ```
/// use kin_core::cycle::{BarkerClass, GrashofType};
///
/// let class = BarkerClass::of(90.0, 30.0, 70.0, 60.0).expect("the links can be assembled");
/// assert_eq!((class, class.number(), class.symbol()), (BarkerClass::CrankRocker, 2, "GCRR"));
/// assert_eq!(class.grashof(), GrashofType::Grashof);
/// assert_eq!(BarkerClass::of(90.0, 30.0, 60.0, 45.0), Some(BarkerClass::GroundLongest));
/// assert_eq!(BarkerClass::of(90.0, 30.0, 20.0, 10.0), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BarkerClass {
    /// 1, GCCC: the ground is shortest, and all other links make full revolutions.
    DoubleCrank,
    /// 2, GCRR: the crank is shortest and makes full revolutions.
    CrankRocker,
    /// 3, GRCR: the coupler is shortest and makes full revolutions.
    DoubleRocker,
    /// 4, GRRC: the rocker is shortest and makes full revolutions.
    RockerCrank,
    /// 5, RRR1: no link makes full revolutions, and the ground is longest.
    GroundLongest,
    /// 6, RRR2: no link makes full revolutions, and the crank is longest.
    CrankLongest,
    /// 7, RRR3: no link makes full revolutions, and the coupler is longest.
    CouplerLongest,
    /// 8, RRR4: no link makes full revolutions, and the rocker is longest.
    RockerLongest,
    /// 9, SCCC: a change point, and the ground is shortest.
    ChangePointDoubleCrank,
    /// 10, SCRR: a change point, and the crank is shortest.
    ChangePointCrankRocker,
    /// 11, SRCR: a change point, and the coupler is shortest.
    ChangePointDoubleRocker,
    /// 12, SRRC: a change point, and the rocker is shortest.
    ChangePointRockerCrank,
    /// 13, S2X: two pairs of equal links, a parallelogram or a kite.
    TwoPairs,
    /// 14, S3X: all links are equal.
    AllEqual,
}

impl BarkerClass {
    /// The class of a linkage with four positive lengths; `None` if one link is longer than the others together, so
    /// that it cannot be assembled, or if a length is not a positive number.
    #[must_use]
    pub fn of(ground: f64, crank: f64, coupler: f64, rocker: f64) -> Option<Self> {
        let links = [ground, crank, coupler, rocker];
        if !links.iter().all(|length| *length > 0.0 && length.is_finite()) {
            return None;
        }
        let sum: f64 = links.iter().sum();
        let extreme = |is_better: fn(f64, f64) -> bool| {
            (1..4).fold(0, |best, link| {
                if is_better(links[link], links[best]) {
                    link
                } else {
                    best
                }
            })
        };
        let (shortest, longest) = (extreme(|one, best| one < best), extreme(|one, best| one > best));
        let [short, long] = [links[shortest], links[longest]];
        if sign(2.0 * long - sum, sum).is_ge() {
            return None;
        }
        let by_link = |classes: [Self; 4], link: usize| Some(classes[link]);
        let equal = |one: f64, other: f64| sign(one - other, sum).is_eq();
        match sign(2.0 * (short + long) - sum, sum) {
            core::cmp::Ordering::Less => by_link(
                [
                    Self::DoubleCrank,
                    Self::CrankRocker,
                    Self::DoubleRocker,
                    Self::RockerCrank,
                ],
                shortest,
            ),
            core::cmp::Ordering::Greater => by_link(
                [
                    Self::GroundLongest,
                    Self::CrankLongest,
                    Self::CouplerLongest,
                    Self::RockerLongest,
                ],
                longest,
            ),
            core::cmp::Ordering::Equal if equal(short, long) => Some(Self::AllEqual),
            core::cmp::Ordering::Equal
                if links.iter().filter(|length| equal(**length, short)).count() == 2
                    && links.iter().filter(|length| equal(**length, long)).count() == 2 =>
            {
                Some(Self::TwoPairs)
            }
            core::cmp::Ordering::Equal => by_link(
                [
                    Self::ChangePointDoubleCrank,
                    Self::ChangePointCrankRocker,
                    Self::ChangePointDoubleRocker,
                    Self::ChangePointRockerCrank,
                ],
                shortest,
            ),
        }
    }

    /// Barker's number, 1 to 14.
    #[must_use]
    pub const fn number(self) -> u8 {
        self as u8 + 1
    }

    /// Barker's symbol.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        [
            "GCCC", "GCRR", "GRCR", "GRRC", "RRR1", "RRR2", "RRR3", "RRR4", "SCCC", "SCRR", "SRCR", "SRRC", "S2X",
            "S3X",
        ][self as usize]
    }

    /// Grashof's type.
    #[must_use]
    pub const fn grashof(self) -> GrashofType {
        match self.number() {
            1..=4 => GrashofType::Grashof,
            5..=8 => GrashofType::NonGrashof,
            _ => GrashofType::ChangePoint,
        }
    }
}

/// The types of slider-cranks. They are four-bars whose ground and rocker are infinitely long: Grashof's condition
/// compares the difference of crank and coupler with the offset.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SliderCrankType {
    /// The crank makes full revolutions: crank + offset < coupler.
    TurningCrank,
    /// The coupler makes full revolutions, and the crank swings: coupler + offset < crank.
    TurningCoupler,
    /// Neither makes full revolutions: the offset is larger than the difference of both.
    Swinging,
    /// The offset equals the difference of both.
    ChangePoint,
}

impl SliderCrankType {
    /// The type of a slider-crank; `None` if the offset is not smaller than crank and coupler together, so that it
    /// cannot be assembled.
    #[must_use]
    pub fn of(crank: f64, coupler: f64, offset: f64) -> Option<Self> {
        let size = crank + coupler + offset;
        if !(crank > 0.0 && coupler > 0.0 && offset >= 0.0 && size.is_finite())
            || sign(crank + coupler - offset, size).is_le()
        {
            return None;
        }
        Some(match sign((crank - coupler).abs() - offset, size) {
            core::cmp::Ordering::Equal => Self::ChangePoint,
            core::cmp::Ordering::Less => Self::Swinging,
            core::cmp::Ordering::Greater if crank < coupler => Self::TurningCrank,
            core::cmp::Ordering::Greater => Self::TurningCoupler,
        })
    }
}

/// The types of inverted slider-cranks: a crank whose pin is in a slide on a link that rotates about a second pivot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum InvertedSliderCrankType {
    /// Crank and link make full revolutions, as in Whitworth's mechanism: ground + offset < crank.
    TurningLink,
    /// The crank makes full revolutions and the link swings, as in a shaper: crank + offset < ground.
    SwingingLink,
    /// The crank swings: the offset is larger than the difference of crank and ground.
    SwingingCrank,
    /// The offset equals the difference of both.
    ChangePoint,
}

impl InvertedSliderCrankType {
    /// The type of an inverted slider-crank; `None` if the offset is not smaller than ground and crank together, so
    /// that it cannot be assembled.
    #[must_use]
    pub fn of(ground: f64, crank: f64, offset: f64) -> Option<Self> {
        let size = ground + crank + offset;
        if !(ground > 0.0 && crank > 0.0 && offset >= 0.0 && size.is_finite())
            || sign(ground + crank - offset, size).is_le()
        {
            return None;
        }
        Some(match sign((crank - ground).abs() - offset, size) {
            core::cmp::Ordering::Equal => Self::ChangePoint,
            core::cmp::Ordering::Less => Self::SwingingCrank,
            core::cmp::Ordering::Greater if crank > ground => Self::TurningLink,
            core::cmp::Ordering::Greater => Self::SwingingLink,
        })
    }
}

/// The label of a block that is shaped like a four-bar.
///
/// ```
/// use kin_core::cycle::{BarkerClass, BlockClass};
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// let [form] = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 }.block_forms();
/// assert_eq!(BlockClass::of(&form), Some(BlockClass::FourBar(BarkerClass::CrankRocker)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum BlockClass {
    /// A four-bar.
    FourBar(BarkerClass),
    /// A slider-crank.
    SliderCrank(SliderCrankType),
    /// An inverted slider-crank.
    InvertedSliderCrank(InvertedSliderCrankType),
}

impl BlockClass {
    /// The label of a block. `None` if it has another form, or cannot be assembled.
    #[must_use]
    pub fn of(form: &BlockForm<f64>) -> Option<Self> {
        match *form {
            BlockForm::FourBar {
                ground,
                crank,
                coupler,
                rocker,
                ..
            } => BarkerClass::of(ground, crank, coupler, rocker).map(Self::FourBar),
            BlockForm::SliderCrank {
                crank, coupler, offset, ..
            } => SliderCrankType::of(crank, coupler, offset).map(Self::SliderCrank),
            BlockForm::InvertedSliderCrank {
                ground, crank, offset, ..
            } => InvertedSliderCrankType::of(ground, crank, offset).map(Self::InvertedSliderCrank),
            _ => None,
        }
    }
}
