//! The names of types, as files and functions are called.

use alloc::string::String;

/// A type's name in small letters, with a sign between its words.
///
/// ```
/// use kin_core::in_small_letters;
///
/// assert_eq!(in_small_letters("FourBar", '_'), "four_bar");
/// assert_eq!(in_small_letters("StephensonIIIByDyad", '-'), "stephenson-iii-by-dyad");
/// assert_eq!(in_small_letters("Four_Bar", '_'), "four_bar");
/// ```
#[doc(hidden)]
#[must_use]
pub fn in_small_letters(name: &str, between: char) -> String {
    let letters: alloc::vec::Vec<char> = name.chars().collect();
    let mut small = String::new();
    for (index, letter) in letters.iter().enumerate() {
        let before = index
            .checked_sub(1)
            .map(|before| letters[before])
            .filter(|before| *before != '_');
        let begins = letter.is_uppercase()
            && before.is_some_and(|before| {
                !before.is_uppercase() || letters.get(index + 1).is_some_and(|next| next.is_lowercase())
            });
        if begins {
            small.push(between);
        }
        small.extend(letter.to_lowercase());
    }
    small
}
