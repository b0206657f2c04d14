//! Errors of mechanisms without a type, with their names.

use core::fmt::{self, Display, Write};

use super::Description;
use crate::quantity::{Name, NameKind};

/// A value, for example an error, shown with the names of a mechanism instead of their indices.
///
/// ```
/// use kin_core::any::{Described, Name, NameKind, Named, Of};
/// use kin_core::library::FourBar;
///
/// let description = Of::<FourBar>::FUNCTIONS.description();
/// let message = format!("{} is too short", Name::by_index(NameKind::Parameter, 2));
/// assert_eq!(message, "‹parameter 2› is too short");
/// assert_eq!(Named::new(&message, description).to_string(), "r3 is too short");
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Named<'n, V> {
    value: V,
    description: &'n Description<'n>,
}

impl<'n, V> Named<'n, V> {
    /// The value with the names of a description.
    pub const fn new(value: V, description: &'n Description<'n>) -> Self {
        Self { value, description }
    }
}

impl<V: Display> Display for Named<'_, V> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut names = NameWriter {
            description: self.description,
            formatter,
            index: None,
        };
        write!(names, "{}", self.value)?;
        names.flush()
    }
}

/// The longest text between brackets that may stand for a name.
const LONGEST_INDEX: usize = "parameter 65535".len();

/// A writer that puts names instead of indices.
struct NameWriter<'n, 'f, 'g> {
    description: &'n Description<'n>,
    formatter: &'f mut fmt::Formatter<'g>,
    /// The text behind a bracket, and its length.
    index: Option<([u8; LONGEST_INDEX], usize)>,
}

impl<'n> NameWriter<'n, '_, '_> {
    /// Writes a bracket, and the text behind it, that stand for no name.
    fn flush(&mut self) -> fmt::Result {
        if let Some((text, length)) = self.index.take() {
            self.formatter.write_char(Name::BRACKETS[0])?;
            self.formatter
                .write_str(str::from_utf8(&text[..length]).unwrap_or_default())?;
        }
        Ok(())
    }

    /// The name that the text behind a bracket stands for.
    fn name(&self) -> Option<&'n str> {
        let (text, length) = self.index.as_ref()?;
        let (word, index) = str::from_utf8(&text[..*length]).ok()?.split_once(' ')?;
        let (of, _) = NameKind::ALL.iter().find(|(_, word_of_kind)| *word_of_kind == word)?;
        self.description.name_of(*of, index.parse().ok()?)
    }
}

impl Write for NameWriter<'_, '_, '_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let [before, after] = Name::BRACKETS;
        for letter in text.chars() {
            if letter == before {
                self.flush()?;
                self.index = Some(([0; LONGEST_INDEX], 0));
                continue;
            }
            match &mut self.index {
                Some((text, length)) if letter.is_ascii() && *length < LONGEST_INDEX => {
                    letter.encode_utf8(&mut text[*length..]);
                    *length += 1;
                    continue;
                }
                Some(_) if letter == after => {
                    if let Some(name) = self.name() {
                        self.index = None;
                        self.formatter.write_str(name)?;
                        continue;
                    }
                }
                _ => {}
            }
            self.flush()?;
            self.formatter.write_char(letter)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::string::ToString;

    use super::Named;
    use crate::library::FourBar;
    use crate::mechanism::Mechanism;

    #[test]
    fn only_indices_become_names() {
        let description = FourBar::<f64>::DESCRIPTION;
        for (text, named) in [
            ("‹block 0› at ‹input 0›", "theta3, theta4 at theta2"),
            ("‹unknown 1›‹parameter 0›", "theta4r1"),
            (
                "‹unknown 7› ‹known 0› ‹› ‹‹input 0›",
                "‹unknown 7› ‹known 0› ‹› ‹theta2",
            ),
            (
                "‹a text that is too long for a name›",
                "‹a text that is too long for a name›",
            ),
            ("θ‹é› ‹open", "θ‹é› ‹open"),
        ] {
            assert_eq!(Named::new(text, &description).to_string(), named);
        }
    }
}
