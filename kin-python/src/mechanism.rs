//! The class of a declared mechanism.

use std::sync::Arc;

use pyo3::prelude::*;

use crate::declared::Declared;

/// A mechanism: loop closure equations, from which positions and all derivatives are solved.
///
/// The text is the one between the braces of `mechanism! { … }` in Rust. With dimensions a mechanism becomes a linkage.
/// Mistakes of the text are a `kin.DeclarationError`.
///
/// >>> import kin
/// >>> slider_crank = kin.Mechanism("""
/// ...     struct SliderCrank { r: Length, l: Length }
/// ...     input theta: Angle;
/// ...     unknown phi: Angle, s: Length;
/// ...     r * cis(theta) + l * cis(phi) == vec2(s, 0);
/// ... """)
/// >>> slider_crank.dimensions, slider_crank.inputs, slider_crank.unknowns
/// (('r', 'l'), ('theta',), ('phi', 's'))
/// >>> press = slider_crank(r=0.1, l=0.3)
/// >>> round(press.solve(theta=0.0, assembly="open").s.position, 12)
/// 0.4
#[pyclass(frozen, module = "kin")]
pub(crate) struct Mechanism {
    pub(crate) declared: Arc<Declared>,
}
