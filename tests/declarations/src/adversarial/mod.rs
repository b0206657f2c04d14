//! Declarations that go to an extreme: deep, wide, long, of large powers, of numbers at the ends of what can be
//! written.

mod algebra;
mod deep;
mod strange;
mod wide;

use crate::Scale;
use crate::random::Random;

/// A family of declarations, one for each size.
pub struct Family {
    /// Its name.
    pub name: &'static str,
    /// The largest size that is drawn.
    pub largest: usize,
    write: fn(&mut Random, usize) -> String,
}

impl Family {
    /// The declaration of a size.
    #[must_use]
    pub fn declaration(&self, random: &mut Random, size: usize) -> String {
        (self.write)(random, size)
    }
}

macro_rules! families {
    ($($module:ident::$name:ident to $largest:literal)+) => {
        /// All families.
        pub const FAMILIES: &[Family] = &[$(Family {
            name: stringify!($name),
            largest: $largest,
            write: $module::$name,
        }),+];
    };
}

families! {
    deep::parentheses to 400
    deep::signs to 600
    algebra::terms to 600
    algebra::factors to 120
    algebra::powers_of_one_factor to 120
    algebra::linear_factors to 40
    algebra::unit_vectors to 30
    deep::nested_functions to 100
    deep::nested_methods to 400
    deep::nested_roots to 60
    deep::nested_norms to 20
    deep::nested_fractions to 60
    deep::squares_in_a_chain to 16
    deep::abbreviations_in_a_chain to 200
    deep::abbreviations_used_twice to 60
    deep::frames_in_a_row to 60
    algebra::power_of_a_sum to 64
    algebra::powers_of_powers to 12
    algebra::powers_of_length to 30
    wide::serial_arm to 12
    algebra::rotations_in_a_product to 12
    algebra::angles_in_a_sum to 60
    algebra::multiples_of_an_angle to 64
    wide::four_bars_in_series to 16
    wide::ring_of_products to 14
    wide::dense_linear_equations to 12
    wide::dense_equations to 8
    wide::polygon to 20
    wide::many_inputs to 60
    wide::many_outputs to 300
    wide::many_parameters to 500
    wide::many_unknowns to 100
    wide::copies to 60
    wide::too_many_equations to 60
    wide::high_order to 12
    wide::sensitivities_of_all_orders to 12
    strange::extreme_numbers to 6
    strange::numbers_that_vanish to 8
    strange::extreme_ranges to 3
    strange::odd_literals to 6
    strange::unusual_names to 12
    strange::forbidden_names to 4
    strange::nothing_said to 40
    algebra::identities to 12
    deep::nested_groups to 200
    strange::tokens_at_random to 120
    strange::statements_at_random to 30
    strange::documentation_and_attributes to 30
    strange::one_name_for_all to 6
}

/// A mechanism with one equation for the unknown `u` of a length `a` and an angle `t`, whatever else there is to use.
fn equation(left: &str, right: &str) -> String {
    format!(
        "struct M {{ a: Length }} input t: Angle; unknown u: Length; {left} == {right}; output o: Length = a * \
            cos(t) + u;"
    )
}

/// The same for an unknown number `n`.
fn equation_of_numbers(left: &str, right: &str) -> String {
    format!(
        "struct M {{ a: Length, k: Scalar }} input t: Angle; unknown n: Scalar; {left} == {right}; output o: Length \
            = a * cos(t) + k * n * a;"
    )
}

fn repeated(count: usize, between: &str, each: impl FnMut(usize) -> String) -> String {
    (0..count).map(each).collect::<Vec<_>>().join(between)
}

/// Something to make a function of: the input, or the unknown.
fn argument(random: &mut Random) -> &'static str {
    let arguments = ["t", "n", "k * t", "n + t", "k * n", "2 * n - t"];
    arguments[random.below(arguments.len())]
}

/// A declaration of one of the families, small ones as likely as large ones.
pub(crate) fn declaration(random: &mut Random, scale: Scale) -> String {
    let family = random.pick(FAMILIES);
    let largest = match scale {
        Scale::Small => family.largest.min(12),
        Scale::Full => family.largest,
    };
    let size = random.size(largest);
    family.declaration(random, size)
}
