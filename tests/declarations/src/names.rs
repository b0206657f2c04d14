//! Names of quantities: ordinary ones, and those that a person should not choose.

use std::collections::BTreeSet;

use crate::random::Random;

/// Names of quantities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Naming {
    /// A letter and a number.
    Plain,
    /// Among them names in other scripts, and those that generated code might use for itself.
    Unusual,
}

/// Names that are good ones by the rules of the language.
const UNUSUAL: &str = "θ φ größe длина 角度 ελ naïve é ﬁ ß ǅ İ ſ µ μ ℓ ª a_ _a __a a__b _0 x y z i n m s t e pi Pi p_x \
    p_y p_z x_y sin_t cos_t assembly near failure pose position result candidate size first second value values \
    velocity \
    acceleration jerk snap crackle pop derivative_7 motion motions rate rates order with test sensitivities \
    transmission_angles solve solve_all solve_near batch position_near assembly_at assemblies_at closure \
    skeleton track convert parameters inputs unknowns outputs clone eq fmt deref into from default kin core std \
    alloc kin_core kin_macros f64 usize bool str Length Angle Scalar Point Motion Assembly Mechanism Option Result \
    union auto raw safe macro_rules index guess input_ lanes batch by turn";

/// Names that are none, or that the language keeps for itself.
const FORBIDDEN: &str = "type fn async dyn gen try abstract priv self Self super crate box typeof in where as mut \
    static struct true _ __ r#type r#a r#input r#let r#sin r#_a input unknown let output PI sin cis powi vec2 \
    rot norm 'a 1a $a a.b a::b a! \
    r#PI";

/// Hands out names that differ from each other.
#[derive(Debug)]
pub(crate) struct Names {
    naming: Naming,
    taken: BTreeSet<String>,
    count: usize,
}

impl Names {
    pub(crate) const fn new(naming: Naming) -> Self {
        Self {
            naming,
            taken: BTreeSet::new(),
            count: 0,
        }
    }

    /// A name nobody else has; an ordinary one begins with the given letters.
    pub(crate) fn name(&mut self, random: &mut Random, letters: &str) -> String {
        if self.naming == Naming::Unusual && random.one_in(3) {
            let name = unusual(random);
            if self.taken.insert(name.clone()) {
                return name;
            }
        }
        loop {
            self.count += 1;
            let name = format!("{letters}{}", self.count);
            if self.taken.insert(name.clone()) {
                return name;
            }
        }
    }
}

/// A name that is allowed and seldom chosen.
pub(crate) fn unusual(random: &mut Random) -> String {
    if random.one_in(30) {
        return "long_".repeat(random.size(200)) + "name";
    }
    random.word(UNUSUAL).to_owned()
}

/// A name that is not allowed.
pub(crate) fn forbidden(random: &mut Random) -> String {
    random.word(FORBIDDEN).to_owned()
}
