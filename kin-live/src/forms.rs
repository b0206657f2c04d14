//! The forms of the blocks, with their lengths.

use kin_compiler::lowered::{BlockKind, Component, Form, Statement, Symbol};
use kin_core::__private::length;
use kin_core::any::{Name, NameKind};
use kin_core::{BlockForm, Scalar};

use crate::code::{Labels, TooLarge};
use crate::routine::{Inputs, Routine};

/// The forms of the blocks of a mechanism.
#[derive(Debug)]
pub(crate) struct Forms {
    forms: Vec<Form>,
    lengths: Routine,
}

impl Forms {
    /// The forms, and the statements that find their lengths.
    pub(crate) fn new(forms: &[Form], statements: &[Statement], labels: &mut Labels<'_>) -> Result<Self, TooLarge> {
        Ok(Self {
            forms: forms.to_vec(),
            lengths: Routine::of_components(statements, &components(forms), labels)?,
        })
    }

    /// Passes each form to `found`.
    pub(crate) fn each<T: Scalar>(&self, parameters: &[T], found: &mut dyn FnMut(BlockForm<T>)) {
        let none = Inputs::positions(&[]);
        self.lengths.run(parameters, none, &[], |result| {
            let mut next = 0;
            let mut component = || {
                next += 1;
                result(next - 1)
            };
            let mut length = |parts: [Component; 2]| match parts {
                [_, Component::Number(0.0)] | [Component::Number(0.0), _] => component(),
                _ => {
                    let (x, y) = (component(), component());
                    length(x, y)
                }
            };
            for form in &self.forms {
                found(block_form(form, &mut length));
            }
        });
    }
}

/// The components of the lengths, in the order in which `each` reads them.
fn components(forms: &[Form]) -> Vec<Component> {
    let lengths = forms.iter().flat_map(|form| form.lengths.iter().flatten());
    lengths
        .flat_map(|parts| match parts {
            [only, Component::Number(0.0)] | [Component::Number(0.0), only] => vec![*only],
            both => both.to_vec(),
        })
        .collect()
}

fn block_form<T: Scalar>(form: &Form, length: &mut impl FnMut([Component; 2]) -> T) -> BlockForm<T> {
    let mut lengths = form.lengths.iter().map(|parts| parts.map(&mut *length));
    let mut next = || lengths.next().flatten();
    let Some(driver) = form.driver else {
        return match form.kind {
            BlockKind::TwoLinks => {
                let first = next();
                BlockForm::two_links(first, next())
            }
            BlockKind::LinkAndSlider => BlockForm::link_and_slider(next()),
            BlockKind::SliderOnLink => BlockForm::slider_on_link(next()),
            BlockKind::PlacedLink => BlockForm::PlacedLink,
            BlockKind::Linear => BlockForm::Linear,
            BlockKind::Quadratic => BlockForm::Quadratic,
            BlockKind::CosineSine => BlockForm::CosineSine,
            BlockKind::Inverse => BlockForm::Inverse,
            BlockKind::FourBar | BlockKind::SliderCrank | BlockKind::InvertedSliderCrank | BlockKind::Coupled => {
                BlockForm::Coupled
            }
        };
    };
    let driver = match driver {
        Symbol::Input(index) => Name::by_index(NameKind::Input, index),
        Symbol::Unknown(index) => Name::by_index(NameKind::Unknown, index),
        _ => unreachable!("only inputs and unknowns move"),
    };
    let mut known = || next().unwrap_or_else(|| unreachable!("a driven block has its lengths"));
    match form.kind {
        BlockKind::SliderCrank => BlockForm::slider_crank(driver, std::array::from_fn(|_| known())),
        BlockKind::InvertedSliderCrank => BlockForm::inverted_slider_crank(driver, std::array::from_fn(|_| known())),
        _ => BlockForm::four_bar(driver, std::array::from_fn(|_| known())),
    }
}
