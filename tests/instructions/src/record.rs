//! The counts that were written down, and how many more there may be.

use std::collections::BTreeMap;
use std::env::consts::ARCH;
use std::fmt::Write;
use std::fs;

/// Where they are written down.
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/recorded.txt");

/// The compiler that built this program.
const COMPILER: &str = env!("KIN_COMPILER");

/// Of a thousand, how many instructions may be added if the compiler is the one of the record. The C library's copying
/// of memory is all that may then differ from one machine to another.
const ALLOWANCE: u64 = 5;

/// The same if it is another one, which may compile better or worse.
const ALLOWANCE_OF_ANOTHER_COMPILER: u64 = 100;

/// Instructions by names, and what counted them.
#[derive(Debug, PartialEq)]
pub(crate) struct Record {
    compiler: String,
    architecture: String,
    /// Instructions per pose.
    pub(crate) counts: BTreeMap<String, u64>,
}

impl Record {
    /// The record of what this build counted.
    pub(crate) fn of_this_build(counts: BTreeMap<String, u64>) -> Self {
        Self {
            compiler: COMPILER.to_owned(),
            architecture: ARCH.to_owned(),
            counts,
        }
    }

    pub(crate) fn read() -> Result<Self, String> {
        let text = fs::read_to_string(FILE).map_err(|error| format!("{FILE} cannot be read: {error}"))?;
        Self::parse(&text).ok_or_else(|| format!("{FILE} is not what `--record` writes"))
    }

    pub(crate) fn write(&self) -> Result<(), String> {
        fs::write(FILE, self.text()).map_err(|error| format!("{FILE} cannot be written: {error}"))?;
        println!("written: {FILE}");
        Ok(())
    }

    fn parse(text: &str) -> Option<Self> {
        let mut words = BTreeMap::new();
        for line in text.lines().filter(|line| !line.starts_with('#')) {
            let (name, value) = line.split_once(' ')?;
            words.insert(name.to_owned(), value);
        }
        let compiler = words.remove("compiler")?.to_owned();
        let architecture = words.remove("architecture")?.to_owned();
        let counts = words.into_iter().map(|(name, count)| Some((name, count.parse().ok()?)));
        Some(Self {
            compiler,
            architecture,
            counts: counts.collect::<Option<_>>()?,
        })
    }

    fn text(&self) -> String {
        let mut text = format!(
            "# Instructions per pose. Renewed by `cargo run --profile bench -p kin-instructions -- --record`.\n\
             compiler {}\narchitecture {}\n",
            self.compiler, self.architecture
        );
        for (name, count) in &self.counts {
            writeln!(text, "{name} {count}").expect("a string can be written");
        }
        text
    }

    /// How many of a thousand instructions these counts may have more than the recorded ones.
    fn allowance(&self) -> u64 {
        if self.compiler == COMPILER {
            ALLOWANCE
        } else {
            ALLOWANCE_OF_ANOTHER_COMPILER
        }
    }

    /// # Errors
    /// The functions with more instructions than are allowed, or recorded or counted alone.
    pub(crate) fn refuse(&self, counts: &BTreeMap<String, u64>) -> Result<(), String> {
        if self.architecture != ARCH {
            println!("the record is for {}: nothing is compared", self.architecture);
            return Ok(());
        }
        let allowance = self.allowance();
        let mut faults = Vec::new();
        for (name, count) in counts {
            match self.counts.get(name) {
                Some(recorded) if 1000 * count > (1000 + allowance) * recorded => {
                    faults.push(format!("{name} takes {count} instructions and took {recorded}"));
                }
                Some(_) => (),
                None => faults.push(format!("{name} is not recorded")),
            }
        }
        let lost = self.counts.keys().filter(|name| !counts.contains_key(*name));
        faults.extend(lost.map(|name| format!("{name} is recorded and was not counted")));
        if faults.is_empty() {
            return Ok(());
        }
        Err(format!(
            "{}\n(up to {allowance} more of a thousand are allowed, as the record is of rustc {} and this is \
             {COMPILER}; if it has to be so, renew the record \
             by `cargo run --profile bench -p kin-instructions -- --record`)",
            faults.join("\n"),
            self.compiler
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::{ARCH, BTreeMap, Record};

    fn of(counts: &[(&str, u64)]) -> BTreeMap<String, u64> {
        counts
            .iter()
            .map(|(name, count)| ((*name).to_owned(), *count))
            .collect()
    }

    #[test]
    fn what_is_written_is_read() {
        let record = Record::of_this_build(of(&[("one", 712), ("two", 41)]));
        assert_eq!(Record::parse(&record.text()), Some(record));
        assert_eq!(
            Record::parse("compiler 1.95.0\none 712\n"),
            None,
            "without an architecture"
        );
    }

    #[test]
    fn more_than_allowed_is_refused() {
        let record = Record::of_this_build(of(&[("one", 712), ("two", 41)]));
        assert_eq!(record.refuse(&of(&[("one", 715), ("two", 30)])), Ok(()));
        let one = record.refuse(&of(&[("one", 716), ("two", 41)])).unwrap_err();
        assert!(one.starts_with("one takes 716 instructions and took 712\n"), "{one}");
        let two = record.refuse(&of(&[("one", 712), ("two", 42)])).unwrap_err();
        assert!(two.starts_with("two takes 42 instructions and took 41\n"), "{two}");
    }

    #[test]
    fn more_is_allowed_for_another_compiler() {
        let mut record = Record::of_this_build(of(&[("one", 100)]));
        record.compiler.push_str("-other");
        assert_eq!(record.refuse(&of(&[("one", 110)])), Ok(()));
        assert!(record.refuse(&of(&[("one", 111)])).is_err());
        record.architecture = format!("not {ARCH}");
        assert_eq!(record.refuse(&of(&[("one", 111)])), Ok(()));
    }

    #[test]
    fn what_is_in_one_only_is_refused() {
        let record = Record::of_this_build(of(&[("one", 712)]));
        let message = record.refuse(&of(&[("two", 41)])).unwrap_err();
        assert!(
            message.starts_with("two is not recorded\none is recorded and was not counted\n"),
            "{message}"
        );
    }
}
