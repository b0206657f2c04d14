//! What each stage leaves for the later ones.

use std::collections::{BTreeMap, BTreeSet};

use super::statement::{Carried, Scheduled, Statement};
use crate::assemble::Program;
use crate::expr::Symbol;

/// What each stage leaves for the later ones.
pub(super) fn hand_on(scheduled: &mut Scheduled, program: &Program) {
    let last = scheduled.stages.len();
    // methods of the mechanism itself, which need not be handed its parameters
    let has_parameters = |stage: usize| stage == 0 || (program.has_sensitivities && stage + 1 == last);
    let mut uses: Vec<BTreeSet<Carried>> = vec![BTreeSet::new(); last];
    let mut symbols: Vec<BTreeSet<Symbol>> = vec![BTreeSet::new(); last];
    let mut carries: Vec<BTreeSet<Carried>> = vec![BTreeSet::new(); last];
    let mut born: BTreeMap<String, usize> = BTreeMap::new();
    let mut systems: BTreeMap<String, usize> = BTreeMap::new();
    for (stage, scheduled_stage) in scheduled.stages.iter().enumerate() {
        for statement in &scheduled_stage.statements {
            for name in statement.uses() {
                let symbol = program.names.symbol(&name);
                let (since, parameter) = match symbol {
                    Some(Symbol::Parameter(index)) => {
                        if has_parameters(stage) {
                            symbols[stage].insert(Symbol::Parameter(index));
                            continue;
                        }
                        (0, Some(index))
                    }
                    Some(symbol @ (Symbol::Input(_) | Symbol::Unknown(_)))
                        if stage > 0 || matches!(symbol, Symbol::Input(_)) =>
                    {
                        symbols[stage].insert(symbol);
                        continue;
                    }
                    // the pose tells cosine and sine of a direction as well
                    Some(symbol @ Symbol::Step(_)) if stage > 0 && program.directions.meaning(symbol).is_some() => {
                        symbols[stage].insert(symbol);
                        continue;
                    }
                    Some(symbol @ (Symbol::InputRate(_, order) | Symbol::UnknownRate(_, order))) => {
                        if stage > order || matches!(symbol, Symbol::InputRate(..)) {
                            symbols[stage].insert(symbol);
                        }
                        continue;
                    }
                    _ => match born.get(&name) {
                        Some(&since) => (since, None),
                        None => continue,
                    },
                };
                if stage > since {
                    let carried = Carried {
                        name: name.clone(),
                        parameter,
                        factors: systems.get(&name).copied(),
                    };
                    uses[stage].insert(carried.clone());
                    for earlier in &mut carries[since..stage] {
                        earlier.insert(carried.clone());
                    }
                }
            }
            if let Statement::Factor { name, matrix } = statement {
                systems.insert(name.clone(), matrix.len());
            }
            for name in statement.defines() {
                born.entry(name).or_insert(stage);
            }
        }
    }
    // an angle that is found beside its unit vector stays with every pose
    let poses = if program.has_sensitivities { last - 1 } else { last };
    for angle in program.directions.angles() {
        for carried in &mut carries[..poses] {
            carried.insert(Carried {
                name: program.names.of(angle).to_owned(),
                parameter: None,
                factors: None,
            });
        }
    }
    for (stage, scheduled_stage) in scheduled.stages.iter_mut().enumerate() {
        scheduled_stage.uses = std::mem::take(&mut uses[stage]).into_iter().collect();
        scheduled_stage.symbols = std::mem::take(&mut symbols[stage]).into_iter().collect();
        scheduled_stage.carries = std::mem::take(&mut carries[stage]).into_iter().collect();
    }
}
