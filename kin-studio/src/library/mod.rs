//! The mechanisms of the library, each with dimensions, inputs and an assembly for which it closes.

mod designs;

pub use designs::{DESIGNS, Design, DesignAssembly};

#[cfg(feature = "gallery")]
use kin_core::{Mechanism, Row};

/// The names of all mechanisms in the order of the book's table, each with the text that declares it, as
/// [`kin_live::Mechanism::declare`] takes it.
#[cfg(feature = "file")]
pub fn declarations() -> impl Iterator<Item = (&'static str, &'static str)> + Clone {
    designs::DESIGNS
        .iter()
        .map(|design| (design.name, design.declaration()))
}

/// An operation on every mechanism of the library.
#[cfg(feature = "gallery")]
pub trait Visitor {
    /// Visits a mechanism, which closes at the inputs, in the assembly.
    fn visit<M: Mechanism<Scalar = f64> + 'static>(
        &mut self,
        mechanism: &M,
        inputs: M::Inputs<f64>,
        assembly: M::Assembly,
    );
}

/// Leads a visitor through all mechanisms, in the order of the book's table.
#[cfg(feature = "gallery")]
pub fn visit(visitor: &mut impl Visitor) {
    macro_rules! visit_all {
        ($($name:ident $file:literal $parameters:tt at $inputs:tt $kind:ident $assembly:tt;)+) => {
            let mut designs = designs::DESIGNS.iter();
            $(visit_one::<kin_core::library::$name>(visitor, designs.next());)+
        };
    }
    designs::each_design!(visit_all);
}

#[cfg(feature = "gallery")]
fn visit_one<M: Mechanism<Scalar = f64> + 'static>(visitor: &mut impl Visitor, design: Option<&Design>) {
    let Some(design) = design else { return };
    let row = |values: &[f64]| M::Inputs::from_fn(|index| values[index]);
    let mechanism = M::from_parameters(Row::from_fn(|index| design.parameters[index]));
    let inputs = row(design.inputs);
    let assembly = match design.assembly {
        DesignAssembly::Named(name) => M::assemblies().find(|assembly| M::assembly_name(*assembly) == name),
        DesignAssembly::Near(near) => Some(mechanism.assembly_at(inputs, Row::from_fn(|index| near[index]))),
    };
    if let Some(assembly) = assembly {
        visitor.visit(&mechanism, inputs, assembly);
    }
}

#[cfg(all(test, feature = "gallery"))]
mod tests {
    use kin_core::library::{AndrewsSqueezer, ChebyshevLinkage, HoekenLinkage, JansenLeg, KlannLeg};

    use super::*;

    /// The names of the mechanisms that close.
    struct Closing(Vec<&'static str>);

    impl Visitor for Closing {
        fn visit<M: Mechanism<Scalar = f64> + 'static>(
            &mut self,
            mechanism: &M,
            inputs: M::Inputs<f64>,
            assembly: M::Assembly,
        ) {
            let found = mechanism.position(inputs, assembly);
            self.0.extend(found.map(|_| M::DESCRIPTION.name));
        }
    }

    #[test]
    fn every_design_closes() {
        let mut closing = Closing(Vec::new());
        visit(&mut closing);
        let names: Vec<&str> = designs::DESIGNS.iter().map(|design| design.name).collect();
        assert_eq!(closing.0, names);
    }

    /// The published results of the library hold for these dimensions.
    #[test]
    fn published_dimensions_are_shown() {
        fn assert_shown<M: Mechanism<Scalar = f64>>(mechanism: &M) {
            let name = M::DESCRIPTION.name;
            let design = designs::DESIGNS.iter().find(|design| design.name == name);
            assert_eq!(
                design.map(|design| design.parameters),
                Some(mechanism.parameters().as_ref())
            );
        }
        assert_shown(&AndrewsSqueezer::PUBLISHED);
        assert_shown(&ChebyshevLinkage::PUBLISHED);
        assert_shown(&HoekenLinkage::PUBLISHED);
        assert_shown(&JansenLeg::HOLY_NUMBERS);
        assert_shown(&KlannLeg::PATENT);
    }
}
