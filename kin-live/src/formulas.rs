//! The formulas of a mechanism, which own their texts.

use kin_compiler::{Formula as OwnedFormula, Formulas as Texts};
use kin_core::any::{Formula, Formulas};
use self_cell::self_cell;

/// The formulas of the blocks, whose texts are borrowed.
struct Blocks<'t> {
    position: Vec<Formula<'t>>,
    velocity: Vec<Formula<'t>>,
}

self_cell!(
    /// Formulas with their texts.
    pub(crate) struct OwnedFormulas {
        owner: Texts,

        #[covariant]
        dependent: Blocks,
    }
);

impl OwnedFormulas {
    pub(crate) fn of(texts: Texts) -> Self {
        Self::new(texts, |texts| {
            let [position, velocity] =
                [&texts.position, &texts.velocity].map(|blocks| blocks.iter().map(formula).collect());
            Blocks { position, velocity }
        })
    }

    /// The formulas.
    pub(crate) fn get(&self) -> Formulas<'_> {
        let texts = self.borrow_owner();
        let [closure, rates, outputs] = [&texts.closure, &texts.rates, &texts.outputs].map(formula);
        let Blocks { position, velocity } = self.borrow_dependent();
        Formulas::new(closure, position, velocity, rates, outputs)
    }
}

fn formula(texts: &OwnedFormula) -> Formula<'_> {
    Formula::new(&texts.text, &texts.mathml, &texts.latex)
}

impl std::fmt::Debug for OwnedFormulas {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.get().fmt(formatter)
    }
}
