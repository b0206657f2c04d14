//! The notation of names: `theta3` is θ₃, `r_1` is r₁, and `omega_dot` is ω with a dot.

/// A name in the notation of the field.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Name {
    pub(super) base: Base,
    /// The indices below the line, in order.
    pub(super) indices: Vec<String>,
    /// The dots above, which mean time derivatives.
    pub(super) dots: usize,
    /// The number of primes, which distinguish names of the formulas from those of the declaration.
    pub(super) primes: usize,
    /// Whether the quantity is a vector.
    pub(super) is_vector: bool,
}

/// The main part of a name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Base {
    /// A single letter, in italics.
    Letter(char),
    /// A whole word, upright.
    Word(String),
}

impl Name {
    /// A single letter without indices.
    pub(super) const fn letter(letter: char) -> Self {
        Self::of(Base::Letter(letter))
    }

    /// An identifier as it is typed, for names that the notation would confuse with others.
    pub(super) fn verbatim(identifier: &str) -> Self {
        Self::of(Base::Word(identifier.to_owned()))
    }

    /// The notation of an identifier.
    pub(super) fn of_identifier(identifier: &str) -> Self {
        let mut parts = identifier.split('_').filter(|part| !part.is_empty());
        let Some(first) = parts.next() else {
            return Self::verbatim(identifier);
        };
        let stem = first.trim_end_matches(|digit: char| digit.is_ascii_digit());
        let digits = &first[stem.len()..];
        if stem.is_empty() {
            return Self::verbatim(identifier);
        }
        let mut name = Self::of(base(stem));
        name.indices.extend((!digits.is_empty()).then(|| digits.to_owned()));
        for part in parts {
            match part {
                "dot" => name.dots += 1,
                "ddot" => name.dots += 2,
                _ => name.indices.push(index(part)),
            }
        }
        name
    }

    const fn of(base: Base) -> Self {
        Self {
            base,
            indices: Vec::new(),
            dots: 0,
            primes: 0,
            is_vector: false,
        }
    }

    /// The name with a further index.
    pub(super) fn indexed(mut self, index: impl Into<String>) -> Self {
        self.indices.push(index.into());
        self
    }

    /// The name, marked as that of a vector or of a number.
    pub(super) fn marked_as_vector(mut self, is_vector: bool) -> Self {
        self.is_vector = is_vector;
        self
    }

    /// Whether the name is written with more than one letter.
    pub(super) const fn is_word(&self) -> bool {
        matches!(self.base, Base::Word(_))
    }
}

fn base(stem: &str) -> Base {
    let mut letters = stem.chars();
    match (letters.next(), letters.next()) {
        (Some(letter), None) => Base::Letter(letter),
        _ => greek(stem).map_or_else(|| Base::Word(stem.to_owned()), Base::Letter),
    }
}

/// An index, with the names of Greek letters replaced.
fn index(part: &str) -> String {
    greek(part).map_or_else(|| part.to_owned(), String::from)
}

/// The Greek letter of a name. π is a number, so `pi` stays a word.
fn greek(word: &str) -> Option<char> {
    let (letter, ..) = GREEK.iter().find(|(_, name, _)| *name == word)?;
    Some(*letter)
}

/// The command of LaTeX for a Greek letter.
pub(super) fn command(letter: char) -> Option<&'static str> {
    let (.., command) = GREEK.iter().find(|(greek, ..)| *greek == letter)?;
    Some(command)
}

/// Greek letters, with their names and their commands in LaTeX.
const GREEK: &[(char, &str, &str)] = &[
    ('α', "alpha", "\\alpha"),
    ('β', "beta", "\\beta"),
    ('γ', "gamma", "\\gamma"),
    ('δ', "delta", "\\delta"),
    ('ε', "epsilon", "\\varepsilon"),
    ('ζ', "zeta", "\\zeta"),
    ('η', "eta", "\\eta"),
    ('θ', "theta", "\\theta"),
    ('ι', "iota", "\\iota"),
    ('κ', "kappa", "\\kappa"),
    ('λ', "lambda", "\\lambda"),
    ('μ', "mu", "\\mu"),
    ('ν', "nu", "\\nu"),
    ('ξ', "xi", "\\xi"),
    ('ρ', "rho", "\\rho"),
    ('σ', "sigma", "\\sigma"),
    ('τ', "tau", "\\tau"),
    ('υ', "upsilon", "\\upsilon"),
    ('φ', "phi", "\\varphi"),
    ('χ', "chi", "\\chi"),
    ('ψ', "psi", "\\psi"),
    ('ω', "omega", "\\omega"),
    ('Γ', "Gamma", "\\Gamma"),
    ('Δ', "Delta", "\\Delta"),
    ('Θ', "Theta", "\\Theta"),
    ('Λ', "Lambda", "\\Lambda"),
    ('Ξ', "Xi", "\\Xi"),
    ('Π', "Pi", "\\Pi"),
    ('Σ', "Sigma", "\\Sigma"),
    ('Φ', "Phi", "\\Phi"),
    ('Ψ', "Psi", "\\Psi"),
    ('Ω', "Omega", "\\Omega"),
    ('π', "", "\\pi"),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// A name as base, indices and dots.
    fn parts(identifier: &str) -> (Base, Vec<String>, usize) {
        let name = Name::of_identifier(identifier);
        (name.base, name.indices, name.dots)
    }

    #[test]
    fn names_are_read_as_letters_indices_and_dots() {
        let letter = |letter: char, indices: &[&str], dots| {
            let indices = indices.iter().map(ToString::to_string).collect::<Vec<_>>();
            (Base::Letter(letter), indices, dots)
        };
        assert_eq!(parts("theta3"), letter('θ', &["3"], 0));
        assert_eq!(parts("r_1"), letter('r', &["1"], 0));
        assert_eq!(parts("r1_x"), letter('r', &["1", "x"], 0));
        assert_eq!(parts("omega_dot"), letter('ω', &[], 1));
        assert_eq!(parts("k_alpha"), letter('k', &["α"], 0));
        assert_eq!(parts("lower_axle").0, Base::Word("lower".to_owned()));
        assert_eq!(parts("pi").0, Base::Word("pi".to_owned()));
        assert_eq!(parts("__").0, Base::Word("__".to_owned()));
        assert_eq!(parts("_3").0, Base::Word("_3".to_owned()));
    }
}
