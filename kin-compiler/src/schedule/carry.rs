//! The values that each stage hands to later stages.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::Symbol;
use crate::program::{Carried, Expression, Program, Step};
use crate::work;

/// Finds the values that each stage of a scheduled program hands to later stages.
pub(crate) fn hand_on(program: &mut Program<Expression>) {
    let last = program.stages.len();
    // methods of the mechanism itself read its parameters directly
    let has_parameters = |stage: usize| stage == 0 || (program.has_sensitivities && stage + 1 == last);
    let mut uses: Vec<BTreeSet<Carried>> = vec![BTreeSet::new(); last];
    let mut reads: Vec<BTreeSet<Symbol>> = vec![BTreeSet::new(); last];
    let mut carries: Vec<BTreeSet<Carried>> = vec![BTreeSet::new(); last];
    let mut born: BTreeMap<Symbol, usize> = BTreeMap::new();
    let mut systems: BTreeMap<Symbol, usize> = BTreeMap::new();
    for (stage, stage_to_carry) in program.stages.iter().enumerate() {
        for step in &stage_to_carry.steps {
            for symbol in step.uses() {
                work::iteration();
                let since = match symbol {
                    Symbol::Parameter(_) if has_parameters(stage) => {
                        reads[stage].insert(symbol);
                        continue;
                    }
                    Symbol::Parameter(_) => 0,
                    Symbol::Input(_) => {
                        reads[stage].insert(symbol);
                        continue;
                    }
                    Symbol::Unknown(_) if stage > 0 => {
                        reads[stage].insert(symbol);
                        continue;
                    }
                    // the pose also has the cosine and sine of a direction
                    Symbol::Step(_) if stage > 0 && program.directions.meaning(symbol).is_some() => {
                        reads[stage].insert(symbol);
                        continue;
                    }
                    Symbol::InputRate(..) => {
                        reads[stage].insert(symbol);
                        continue;
                    }
                    Symbol::UnknownRate(_, order) => {
                        if stage > order {
                            reads[stage].insert(symbol);
                        }
                        continue;
                    }
                    _ => match born.get(&symbol) {
                        Some(&since) => since,
                        None => continue,
                    },
                };
                if stage > since {
                    work::iterations(stage - since);
                    let carried = Carried {
                        symbol,
                        factors: systems.get(&symbol).copied(),
                    };
                    uses[stage].insert(carried);
                    for earlier in &mut carries[since..stage] {
                        earlier.insert(carried);
                    }
                }
            }
            if let Step::Factor { symbol, matrix } = step {
                systems.insert(*symbol, matrix.len());
            }
            for symbol in step.defines() {
                born.entry(symbol).or_insert(stage);
            }
        }
    }
    // an angle that is found beside its unit vector stays in every pose
    let poses = if program.has_sensitivities { last - 1 } else { last };
    for symbol in program.directions.angles() {
        for carried in &mut carries[..poses] {
            carried.insert(Carried { symbol, factors: None });
        }
    }
    let names = &program.names;
    let by_name = |values: &mut BTreeSet<Carried>| {
        let mut values: Vec<Carried> = std::mem::take(values).into_iter().collect();
        values.sort_by_cached_key(|carried| names.of(carried.symbol));
        values
    };
    for (index, stage) in program.stages.iter_mut().enumerate() {
        stage.uses = by_name(&mut uses[index]);
        stage.reads = std::mem::take(&mut reads[index]).into_iter().collect();
        stage.carries = by_name(&mut carries[index]);
    }
}
