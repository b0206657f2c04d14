//! A campaign: many declarations, and the defects that they show.

use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use kin_declarations::{Kind, Scale, declaration};

use super::shrink::shrink;
use super::verdict::{Expansion, Fragments, NO_TOKENS, Subject, expansion};

/// The declarations to expand.
pub(super) struct Campaign {
    /// The first seed.
    pub(super) first: u64,
    pub(super) count: u64,
    pub(super) scale: Scale,
    pub(super) threads: usize,
}

/// The results of a campaign.
#[derive(Default)]
pub(super) struct Findings {
    kinds: BTreeMap<Kind, Tally>,
    /// The defects by cause: their number, and the first of them.
    defects: BTreeMap<String, (usize, Defect)>,
}

#[derive(Default)]
struct Tally {
    accepted: usize,
    refused: usize,
    /// The number of texts that the compiler itself refuses.
    no_tokens: usize,
    defects: usize,
    /// The largest numbers of look-ups and of iterations of other loops for each token read and operation written, each
    /// with its seed.
    most: [(usize, u64); 2],
}

struct Defect {
    seed: u64,
    message: String,
}

/// The number of declarations after which the tally is printed.
const REPORTED: usize = 10_000;

/// The shares of the kinds, in twenty-fifths. Declarations that are refused early cost little.
const fn shares(scale: Scale) -> [(Kind, u64); 4] {
    let [sound, well_typed, damaged, adversarial] = match scale {
        Scale::Small => [1, 3, 19, 2],
        Scale::Full => [4, 5, 12, 4],
    };
    [
        (Kind::Sound, sound),
        (Kind::WellTyped, well_typed),
        (Kind::Damaged, damaged),
        (Kind::Adversarial, adversarial),
    ]
}

impl Campaign {
    /// Expands all declarations.
    ///
    /// # Panics
    /// Panics if there is a defect. Each is shown with a declaration that is as small as possible.
    pub(super) fn run(&self) -> Findings {
        let next = AtomicU64::new(self.first);
        let findings = Mutex::new(Findings::default());
        thread::scope(|scope| {
            for _ in 0..self.threads {
                scope.spawn(|| {
                    loop {
                        let seed = next.fetch_add(1, Ordering::Relaxed);
                        if seed >= self.first + self.count {
                            break;
                        }
                        let result = self.verdict(seed, &self.declaration(seed));
                        let mut findings = findings.lock().expect("nothing panics");
                        findings.note(self.kind(seed), seed, result);
                        if findings.count().is_multiple_of(REPORTED) {
                            println!("{findings}");
                        }
                    }
                });
            }
        });
        let findings = findings.into_inner().expect("nothing panics");
        assert!(findings.defects.is_empty(), "{findings}\n{}", self.described(&findings));
        findings
    }

    fn kind(&self, seed: u64) -> Kind {
        let mut draw = seed % 25;
        for (kind, share) in shares(self.scale) {
            if draw < share {
                return kind;
            }
            draw -= share;
        }
        unreachable!("the shares make twenty-five")
    }

    fn declaration(&self, seed: u64) -> String {
        declaration(self.kind(seed), seed, self.scale)
    }

    /// The expansion of a declaration, or its defect.
    fn verdict(&self, seed: u64, declaration: &str) -> Result<Expansion, String> {
        let kind = self.kind(seed);
        let subject = Subject {
            name: &format!("{} {seed}", kind.word()),
            declaration,
            fragments: match kind {
                _ if !seed.is_multiple_of(7) => Fragments::None,
                Kind::Sound => Fragments::Operands(seed),
                _ => Fragments::Any(seed),
            },
            twice: seed.is_multiple_of(16),
        };
        let expansion = expansion(subject)?;
        match &expansion.refusal {
            // the generator adds numbers to angles without looking at their sum, which may be beyond a revolution
            Some(message) if kind == Kind::Sound && !message.contains("angles are in radians") => {
                Err(format!("it is sound, and refused: {message}"))
            }
            _ => Ok(expansion),
        }
    }

    /// Every defect with a declaration that shows it.
    fn described(&self, findings: &Findings) -> String {
        let line = |(cause, (count, Defect { seed, message })): (&String, &(usize, Defect))| {
            let text = self.declaration(*seed);
            let has_it = |text: &str| {
                let verdict = self.verdict(*seed, text);
                verdict.is_err_and(|message| *cause == self::cause(&message))
            };
            // refusing a part of a sound declaration may be correct, and waiting for each part takes long
            let keeps = message.contains("it is sound") || message.contains("longer");
            let small = if keeps { text } else { shrink(&text, has_it) };
            let kind = self.kind(*seed).word();
            format!("\n{count} times, first by the {kind} seed {seed}: {message}\n{small}\n")
        };
        findings.defects.iter().map(line).collect()
    }
}

impl Findings {
    /// The number of declarations.
    fn count(&self) -> usize {
        let tallies = self.kinds.values();
        let each = tallies.map(|tally| tally.accepted + tally.refused + tally.no_tokens + tally.defects);
        each.sum()
    }

    fn note(&mut self, kind: Kind, seed: u64, result: Result<Expansion, String>) {
        let tally = self.kinds.entry(kind).or_default();
        match result {
            Ok(expansion) => {
                if expansion.refusal.is_none() {
                    tally.accepted += 1;
                } else {
                    tally.refused += 1;
                }
                for (most, rate) in tally.most.iter_mut().zip(expansion.rates()) {
                    *most = (*most).max((rate, seed));
                }
            }
            Err(message) if message == NO_TOKENS => tally.no_tokens += 1,
            Err(message) => {
                println!("seed {seed}: {message}");
                let defect = Defect { seed, message };
                let (count, _) = self.defects.entry(cause(&defect.message)).or_insert((0, defect));
                *count += 1;
                tally.defects += 1;
            }
        }
    }
}

/// The common part of the messages of one cause: the first line of a panic is its position, and messages differ in
/// quoted names.
fn cause(message: &str) -> String {
    let first = message.lines().next().unwrap_or_default();
    first.split('`').step_by(2).collect()
}

impl Display for Findings {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "kind        accepted  refused  no tokens  defects  most look-ups  most iterations, and their seeds"
        )?;
        for (kind, tally) in &self.kinds {
            let Tally {
                accepted,
                refused,
                no_tokens,
                defects,
                most: [(look_ups, first), (iterations, second)],
            } = tally;
            writeln!(
                f,
                "{:11} {accepted:8} {refused:8} {no_tokens:10} {defects:8} {look_ups:14} {iterations:11}  {first} \
                 {second}",
                kind.word()
            )?;
        }
        Ok(())
    }
}
