//! Counts of callgrind, of valgrind.

use std::collections::BTreeMap;
use std::process::Command;
use std::{env, fs};

/// Runs this program again within callgrind, with the given argument, and returns the instructions within each function
/// the name of which begins by `module`, summed over all calls and with all that it called.
pub(crate) fn of_this_program(argument: &str, module: &str) -> Result<BTreeMap<String, u64>, String> {
    let program = env::current_exe().map_err(|error| format!("this program cannot be found: {error}"))?;
    let file = program.with_extension("callgrind");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--compress-strings=no", "--compress-pos=no"])
        .arg(format!("--callgrind-out-file={}", file.display()))
        .arg(&program)
        .arg(argument)
        .output()
        .map_err(|error| format!("valgrind, which has to be installed, cannot be run: {error}"))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(format!("valgrind ended with {}:\n{said}", output.status));
    }
    let profile = fs::read_to_string(&file).map_err(|error| format!("{} cannot be read: {error}", file.display()))?;
    let counts = inclusive(&profile, module);
    if counts.is_empty() {
        return Err(format!("{} has no calls of {module}", file.display()));
    }
    Ok(counts)
}

/// The costs of all calls of the functions of a module, by the functions' names.
///
/// A call is written as three lines, the last of which gives the line of the source and the inclusive cost (valgrind's
/// manual, "Callgrind Format Specification"):
///
/// ```text
/// cfn=kin_instructions::counted::four_bar_position
/// calls=16 0
/// 97 5000
/// ```
fn inclusive(profile: &str, module: &str) -> BTreeMap<String, u64> {
    let mut counts = BTreeMap::new();
    let mut callee = None;
    let mut lines = profile.lines();
    while let Some(line) = lines.next() {
        if let Some(name) = line.strip_prefix("cfn=") {
            callee = name.split_once(module).map(|(_, function)| function);
        } else if line.starts_with("calls=") {
            let cost = lines
                .next()
                .and_then(|line| line.split_whitespace().nth(1)?.parse::<u64>().ok());
            if let (Some(function), Some(cost)) = (callee, cost) {
                *counts.entry(function.to_owned()).or_default() += cost;
            }
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::inclusive;

    #[test]
    fn calls_of_the_module_are_summed() {
        let profile = "events: Ir\nfn=main\n1 7\ncfn=program::counted::one\ncalls=2 0\n3 40\n4 5\n\
                       cfn=other\ncalls=1 0\n3 900\ncfn=program::counted::two\ncalls=1 0\n5 11\n\
                       fn=other\ncfn=program::counted::one\ncalls=1 0\n6 2\n";
        let counts = inclusive(profile, "counted::");
        let expected = [("one".to_owned(), 42), ("two".to_owned(), 11)];
        assert_eq!(counts.into_iter().collect::<Vec<_>>(), expected);
    }
}
