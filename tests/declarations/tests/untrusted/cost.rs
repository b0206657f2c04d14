//! What this process costs. Only Linux tells.

use std::fs;
use std::time::Duration;

/// The fields of a file, `skipped` first.
fn fields(file: &str, of: &str) -> Option<Vec<u64>> {
    let text = fs::read_to_string(file).ok()?;
    let line = text.lines().find(|line| line.starts_with(of))?;
    Some(line.split_whitespace().filter_map(|field| field.parse().ok()).collect())
}

fn bytes(kilobytes: Option<u64>) -> usize {
    kilobytes
        .and_then(|kilobytes| usize::try_from(kilobytes * 1024).ok())
        .unwrap_or(0)
}

/// The resident memory, in bytes.
pub(crate) fn resident() -> usize {
    bytes(fields("/proc/self/status", "VmRSS:").and_then(|fields| fields.first().copied()))
}

/// The most resident memory that there has been, in bytes.
pub(crate) fn most_resident() -> usize {
    bytes(fields("/proc/self/status", "VmHWM:").and_then(|fields| fields.first().copied()))
}

/// The processor time of all threads, to a hundredth of a second.
pub(crate) fn processor_time() -> Duration {
    let text = fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // behind the name of the program, which may contain anything
    let rest = text.rsplit(')').next().unwrap_or_default();
    let ticks: u64 = rest
        .split_whitespace()
        .skip(11)
        .take(2)
        .filter_map(|ticks| ticks.parse::<u64>().ok())
        .sum();
    Duration::from_millis(10 * ticks)
}
