//! The symbols that each expression contains, stored with the expression so that no pass has to search for them.
//!
//! Parameters, inputs and unknowns are recorded one by one. Of all other symbols only their presence is recorded.

use super::{HashMap, Index as _, Node, NodeKind, Symbol};

/// The kinds of symbols in an expression, and the set of its parameters, inputs and unknowns.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Content {
    kinds: u8,
    /// The index of the set; 0 is the empty set.
    set: u32,
}

const PARAMETER: u8 = 1;
const INPUT: u8 = 2;
const UNKNOWN: u8 = 4;
const STEP: u8 = 8;
/// A rate, a sensitivity or an output.
const RATE: u8 = 16;

impl Content {
    pub(super) const fn is_constant(self) -> bool {
        self.kinds == 0
    }

    pub(super) const fn has_unknowns(self) -> bool {
        self.kinds & UNKNOWN != 0
    }

    pub(super) const fn has_inputs_or_unknowns(self) -> bool {
        self.kinds & (INPUT | UNKNOWN) != 0
    }

    pub(super) const fn is_of_position(self) -> bool {
        self.kinds & !(PARAMETER | INPUT | UNKNOWN) == 0
    }

    pub(super) const fn is_constant_in_time(self) -> bool {
        self.kinds & !(PARAMETER | STEP) == 0
    }
}

/// The contents of all expressions of a graph. Equal sets are stored once, so there are few of them.
#[derive(Clone)]
pub(super) struct Contents {
    list: Vec<Content>,
    /// The distinct sets, as bits.
    sets: Vec<Vec<u64>>,
    numbers: HashMap<Vec<u64>, u32>,
    unions: HashMap<(u32, u32), u32>,
}

impl Default for Contents {
    fn default() -> Self {
        Self {
            list: Vec::new(),
            sets: vec![Vec::new()],
            numbers: std::iter::once((Vec::new(), 0)).collect(),
            unions: HashMap::default(),
        }
    }
}

impl Contents {
    pub(super) fn of(&self, node: Node) -> Content {
        self.list[node.index()]
    }

    /// Adds the content of a new expression, whose operands have theirs already.
    pub(super) fn push(&mut self, term: &NodeKind) {
        let content = match term {
            NodeKind::Number(_) | NodeKind::Pi => Content::default(),
            NodeKind::Symbol(symbol) => self.of_symbol(*symbol),
            NodeKind::Sum(_, terms) => self.joined(terms.iter().map(|&(part, _)| part)),
            NodeKind::Product(factors) => self.joined(factors.iter().map(|&(part, _)| part)),
            NodeKind::Call(_, arguments) => self.joined(arguments.iter().copied()),
        };
        self.list.push(content);
    }

    fn of_symbol(&mut self, symbol: Symbol) -> Content {
        let kinds = match symbol {
            Symbol::Parameter(_) => PARAMETER,
            Symbol::Input(_) => INPUT,
            Symbol::Unknown(_) => UNKNOWN,
            Symbol::Step(_) | Symbol::Value(_) => STEP,
            Symbol::InputRate(..)
            | Symbol::UnknownRate(..)
            | Symbol::Turning(..)
            | Symbol::OutputRate(..)
            | Symbol::Sensitivity(..)
            | Symbol::OutputSensitivity(..) => RATE,
        };
        let set = slot(symbol).map_or(0, |slot| {
            let mut bits = vec![0; slot / 64 + 1];
            bits[slot / 64] = 1 << (slot % 64);
            self.number(bits)
        });
        Content { kinds, set }
    }

    fn joined(&mut self, parts: impl Iterator<Item = Node>) -> Content {
        parts.fold(Content::default(), |joined, part| {
            let content = self.of(part);
            Content {
                kinds: joined.kinds | content.kinds,
                set: self.union(joined.set, content.set),
            }
        })
    }

    fn union(&mut self, one: u32, other: u32) -> u32 {
        let key = (one.min(other), one.max(other));
        if key.0 == 0 || key.0 == key.1 {
            return key.1;
        }
        if let Some(&union) = self.unions.get(&key) {
            return union;
        }
        let [short, long] = [&self.sets[key.0 as usize], &self.sets[key.1 as usize]];
        let (short, long) = if short.len() > long.len() {
            (long, short)
        } else {
            (short, long)
        };
        let mut bits = long.clone();
        for (word, more) in bits.iter_mut().zip(short) {
            *word |= more;
        }
        let union = self.number(bits);
        self.unions.insert(key, union);
        union
    }

    fn number(&mut self, bits: Vec<u64>) -> u32 {
        if let Some(&number) = self.numbers.get(&bits) {
            return number;
        }
        let number = u32::try_from(self.sets.len()).expect("fewer than 2^32 sets");
        self.sets.push(bits.clone());
        self.numbers.insert(bits, number);
        number
    }

    /// Whether a content includes a parameter, an input or an unknown.
    pub(super) fn has(&self, content: Content, symbol: Symbol) -> bool {
        let slot = slot(symbol).expect("other symbols are not in the sets");
        self.sets[content.set as usize]
            .get(slot / 64)
            .is_some_and(|word| word >> (slot % 64) & 1 == 1)
    }

    /// The indices of the unknowns in a content, ascending.
    pub(super) fn unknowns(&self, content: Content) -> impl Iterator<Item = usize> + '_ {
        let words = self.sets[content.set as usize].iter().enumerate();
        words
            .flat_map(|(index, word)| {
                (0..64)
                    .filter(move |bit| word >> bit & 1 == 1)
                    .map(move |bit| 64 * index + bit)
            })
            .filter_map(|slot| (slot % 3 == 0).then_some(slot / 3))
    }
}

/// The position of a symbol in the sets.
const fn slot(symbol: Symbol) -> Option<usize> {
    match symbol {
        Symbol::Unknown(index) => Some(3 * index),
        Symbol::Parameter(index) => Some(3 * index + 1),
        Symbol::Input(index) => Some(3 * index + 2),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::algebra::{Graph, Symbol};

    #[test]
    fn contents_are_those_of_all_operands() {
        let mut graph = Graph::new();
        let far = graph.symbol(Symbol::Unknown(130));
        let near = graph.symbol(Symbol::Unknown(3));
        let (input, length) = (graph.symbol(Symbol::Input(0)), graph.symbol(Symbol::Parameter(0)));
        let rate = graph.symbol(Symbol::UnknownRate(3, 1));
        let product = graph.product(&[(far, 2), (input, 1), (length, 1)]);
        let sum = graph.linear(1.0, &[(product, 2.0), (near, 1.0)]);
        assert_eq!(graph.unknowns(sum).collect::<Vec<_>>(), [3, 130]);
        assert!(graph.has_any_of(sum, &[7, 130]) && !graph.has_any_of(sum, &[7, 64]));
        assert!(graph.depends_on_position_alone(sum) && !graph.is_constant_in_time(sum));
        assert!(graph.is_constant_in_time(length) && !graph.has_unknowns(rate));
        assert!(graph.contains(sum, Symbol::Input(0)) && !graph.contains(sum, Symbol::Parameter(130)));
        let all = graph.multiply(sum, rate);
        assert!(!graph.depends_on_position_alone(all));
    }
}
