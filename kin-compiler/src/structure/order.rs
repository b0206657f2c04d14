//! The order of the blocks: the strongly connected components of the matched equations.
//!
//! R. E. Tarjan, "Depth-first search and linear graph algorithms", SIAM Journal on Computing 1(2), 1972. A component is
//! finished after all components that it depends on. So the components come out in the order in which they can be
//! solved.

use std::collections::BTreeSet;

use super::matching::Matching;

struct DepthFirst<'a> {
    incidence: &'a [BTreeSet<usize>],
    matching: &'a Matching,
    /// The time at which each equation was first visited.
    seen: Vec<Option<usize>>,
    /// The earliest equation on the stack that each equation can reach.
    low: Vec<usize>,
    stack: Vec<usize>,
    is_on_stack: Vec<bool>,
    count: usize,
    blocks: Vec<Vec<usize>>,
}

/// The blocks as lists of equations. Each block can be solved after the ones before it.
pub(super) fn blocks(incidence: &[BTreeSet<usize>], matching: &Matching) -> Vec<Vec<usize>> {
    let size = incidence.len();
    let mut search = DepthFirst {
        incidence,
        matching,
        seen: vec![None; size],
        low: vec![0; size],
        stack: Vec::new(),
        is_on_stack: vec![false; size],
        count: 0,
        blocks: Vec::new(),
    };
    for equation in 0..size {
        if search.seen[equation].is_none() {
            search.visit(equation);
        }
    }
    search.blocks
}

impl DepthFirst<'_> {
    fn visit(&mut self, equation: usize) {
        let time = self.count;
        self.count += 1;
        self.seen[equation] = Some(time);
        self.low[equation] = time;
        self.stack.push(equation);
        self.is_on_stack[equation] = true;
        for &unknown in &self.incidence[equation] {
            let needed = self.matching.equation_of(unknown);
            match self.seen[needed] {
                None => {
                    self.visit(needed);
                    self.low[equation] = self.low[equation].min(self.low[needed]);
                }
                Some(time) if self.is_on_stack[needed] => self.low[equation] = self.low[equation].min(time),
                Some(_) => {}
            }
        }
        if self.low[equation] == time {
            let start = self
                .stack
                .iter()
                .position(|&member| member == equation)
                .expect("it was pushed");
            let mut block = self.stack.split_off(start);
            for &member in &block {
                self.is_on_stack[member] = false;
            }
            block.sort_unstable();
            self.blocks.push(block);
        }
    }
}
