#![allow(missing_docs)]
use kin_declarations::{declaration, Kind, Scale};
use std::time::Instant;
fn rss() -> usize {
    let s = std::fs::read_to_string("/proc/self/statm").unwrap();
    s.split(' ').nth(1).unwrap().parse::<usize>().unwrap() * 4096
}
fn hwm() -> usize {
    let s = std::fs::read_to_string("/proc/self/status").unwrap();
    let l = s.lines().find(|l| l.starts_with("VmHWM")).unwrap();
    l.split_whitespace().nth(1).unwrap().parse::<usize>().unwrap() / 1024
}
#[test]
fn explore() {
    let n = |k: &str, d: u64| std::env::var(k).map_or(d, |v| v.parse().unwrap());
    let scale = if n("FULL", 1) == 1 { Scale::Full } else { Scale::Small };
    let mut all = vec![];
    let begin = Instant::now();
    for seed in n("SEED", 0)..n("SEED", 0) + n("COUNT", 1000) {
        let kind = Kind::ALL[(seed % 4) as usize];
        let text = declaration(kind, seed, scale);
        let _ = std::fs::write("/proc/self/clear_refs", "5");
        let start = Instant::now();
        let result = kin_compiler::Declaration::parse_within(&text, &kin_compiler::Budget{ text: 10<<20, work: n("WORK", 1 << 40) as usize });
        let time = start.elapsed().as_secs_f64();
        let high = hwm();
        let ok = match &result { Ok(m) => format!("ok {}", m.work()), Err(e) => e.to_string().lines().next().unwrap_or("").chars().take(80).collect() };
        all.push((time, high, text.len(), seed, kind.word(), ok));
    }
    println!("total {:?} rss {}", begin.elapsed(), rss() >> 20);
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    for a in all.iter().take(40) { println!("{a:?}"); }
    println!("--- by memory");
    all.sort_by(|a, b| b.1.cmp(&a.1));
    for a in all.iter().take(20) { println!("{a:?}"); }
    let panics: Vec<_> = all.iter().filter(|a| a.5.contains("bug in kin")).collect();
    println!("bugs {panics:?}");
}
