//! The processor time and the traffic of processes, where the system reports them by files (Linux).

use std::fs;

/// The processor time of a process in seconds: fields 14 and 15 of `stat`, in hundredths of a second. `self` names this
/// process.
pub(crate) fn seconds(process: &str) -> Option<f64> {
    let stat = fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    // The second field is a name in parentheses, which may hold spaces.
    let (_, fields) = stat.rsplit_once(')')?;
    let ticks: Vec<f64> = fields
        .split_whitespace()
        .skip(11)
        .take(2)
        .filter_map(|field| field.parse().ok())
        .collect();
    Some(ticks.iter().sum::<f64>() / 100.0)
}

/// The bytes that have gone over the loopback interface, whoever sent them.
#[cfg(feature = "cluster")]
pub(crate) fn loopback_bytes() -> Option<f64> {
    let devices = fs::read_to_string("/proc/net/dev").ok()?;
    let counts = devices.lines().find_map(|line| line.trim().strip_prefix("lo:"))?;
    counts.split_whitespace().next()?.parse().ok()
}
