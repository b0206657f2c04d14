//! The form of a block, with the lengths of its links as values.

use crate::number::Number;
use crate::quantity::Name;

/// The form of a block and the lengths that belong to it, as [`Mechanism::block_forms`](crate::Mechanism::block_forms)
/// returns them.
///
/// Lengths are positive and have the unit of the mechanism. If an equation was multiplied by a number, so are its
/// lengths. A length is `None` if it changes with the position, as that of a cylinder does. A dyad whose end is carried
/// by a crank, a link that rotates about a fixed pivot by one angle, is named as a whole: four-bar, slider-crank or
/// inverted slider-crank. The `driver` is the name of that angle, an input or an unknown that is found before the
/// block.
///
/// A sum of vectors does not show which links are joined. In a four-bar the coupler is the link on the crank's side of
/// the equation, or the unknown that was declared first if that does not decide.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_core::BlockForm;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let [form] = linkage.block_forms();
/// let BlockForm::FourBar { driver, ground, crank, coupler, rocker } = form else { panic!("it is a four-bar") };
/// assert_eq!(driver, "theta2");
/// assert_eq!((ground, crank, coupler, rocker), (90.0, 30.0, 60.0, 45.0));
/// // Grashof: the shortest and the longest link are together longer than the others, so no link makes full revolutions
/// assert!(30.0 + 90.0 > 60.0 + 45.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BlockForm<T = f64> {
    /// Two links (RRR dyad) on a crank and on the ground: the circles of the two links meet.
    FourBar {
        /// The angle of the crank.
        driver: Name,
        /// The distance of the two fixed pivots.
        ground: T,
        /// The link that rotates with the driver.
        crank: T,
        /// The link on the crank.
        coupler: T,
        /// The link on the ground.
        rocker: T,
    },
    /// Two links (RRR dyad) whose ends are placed in another way.
    TwoLinks {
        /// The lengths of the links.
        lengths: [Option<T>; 2],
    },
    /// A link and a slider (RRP dyad) on a crank, with the slider's line on the ground.
    SliderCrank {
        /// The angle of the crank.
        driver: Name,
        /// The link that rotates with the driver.
        crank: T,
        /// The link between crank and slider.
        coupler: T,
        /// The distance of the crank's pivot from the line of the slider's joint.
        offset: T,
    },
    /// A link and a slider (RRP dyad) whose ends are placed in another way.
    LinkAndSlider {
        /// The length of the link.
        length: Option<T>,
    },
    /// A slider on a link that rotates about a fixed pivot (RPR dyad), carried by a crank.
    InvertedSliderCrank {
        /// The angle of the crank.
        driver: Name,
        /// The distance of the two fixed pivots.
        ground: T,
        /// The link that rotates with the driver.
        crank: T,
        /// The distance of the slider's joint from the line through the link's pivot along which it slides.
        offset: T,
    },
    /// A slider on a link that rotates (RPR dyad), whose ends are placed in another way.
    SliderOnLink {
        /// The distance of the slider's joint from the line through the link's pivot along which it slides.
        offset: Option<T>,
    },
    /// The direction of a link whose ends other equations have placed.
    PlacedLink,
    /// One or two linear equations.
    Linear,
    /// A quadratic equation or a square root.
    Quadratic,
    /// a cos x + b sin x = c.
    CosineSine,
    /// The inverse of a function.
    Inverse,
    /// Coupled equations, solved by Newton's method.
    Coupled,
}

/// A length is positive, whichever way its link was drawn.
fn positive<T: Number>(length: T) -> T {
    if length.real() < 0.0 { -length } else { length }
}

/// The constructors that generated code calls. Lengths may have either sign.
#[doc(hidden)]
impl<T: Number> BlockForm<T> {
    #[must_use]
    pub fn four_bar(driver: impl Into<Name>, lengths: [T; 4]) -> Self {
        let [ground, crank, coupler, rocker] = lengths.map(positive);
        Self::FourBar {
            driver: driver.into(),
            ground,
            crank,
            coupler,
            rocker,
        }
    }

    #[must_use]
    pub fn two_links(first: Option<T>, second: Option<T>) -> Self {
        Self::TwoLinks {
            lengths: [first, second].map(|length| length.map(positive)),
        }
    }

    #[must_use]
    pub fn slider_crank(driver: impl Into<Name>, lengths: [T; 3]) -> Self {
        let [crank, coupler, offset] = lengths.map(positive);
        Self::SliderCrank {
            driver: driver.into(),
            crank,
            coupler,
            offset,
        }
    }

    #[must_use]
    pub fn link_and_slider(length: Option<T>) -> Self {
        Self::LinkAndSlider {
            length: length.map(positive),
        }
    }

    #[must_use]
    pub fn inverted_slider_crank(driver: impl Into<Name>, lengths: [T; 3]) -> Self {
        let [ground, crank, offset] = lengths.map(positive);
        Self::InvertedSliderCrank {
            driver: driver.into(),
            ground,
            crank,
            offset,
        }
    }

    #[must_use]
    pub fn slider_on_link(offset: Option<T>) -> Self {
        Self::SliderOnLink {
            offset: offset.map(positive),
        }
    }
}

/// The length of a vector by its components. It is exact if one of them is zero.
#[doc(hidden)]
pub fn length<T: Number>(x: T, y: T) -> T {
    if y.real() == 0.0 {
        x
    } else if x.real() == 0.0 {
        y
    } else {
        (x * x + y * y).sqrt()
    }
}
