//! The outline as it follows from the vector equations.
//!
//! Either side of such an equation is a chain from the origin, whose joints are the partial sums of its terms; both
//! sides end in the same joint. Terms that rotate together and share a joint are one body. A term of variable length is
//! a slide.

use std::collections::{BTreeMap, BTreeSet};

use super::SkeletonNames;
use super::groups::Groups;
use super::guess;
use super::outline::{Joint, Picture};
use super::terms::{LinkTerm, terms};
use super::turning::{Manner, SlideDirection, TurningAngles, manner};
use crate::model::ValueShape;
use crate::syntax::{EquationStatement, OutputStatement, TypedFormula};
use crate::translate::tree::{Body, Outline, Slide};

/// The origin of all chains.
const ORIGIN: usize = 0;

/// The picture of some vector equations and the outputs that are points.
pub(super) fn picture<'a>(
    equations: &[&'a EquationStatement],
    points: &[&'a OutputStatement],
    shape: ValueShape,
    names: &SkeletonNames<'a>,
) -> Picture<'a> {
    let mut chains = Chains::new(shape, names);
    for equation in equations {
        let [left, right] = sides(equation, names);
        let (left, right) = (chains.chain(left), chains.chain(right));
        chains.same.unite(left, right);
    }
    chains.unite_consequences();
    let points: Vec<(String, usize)> = points
        .iter()
        .map(|output| (output.name.to_string(), chains.point(&output.value)))
        .collect();
    chains.unite_consequences();
    chains.picture(points)
}

/// The terms of both sides. Of a whole loop that comes to zero, what is subtracted is the other side.
fn sides<'a>(equation: &'a EquationStatement, names: &SkeletonNames<'a>) -> [Vec<LinkTerm<'a>>; 2] {
    let [left, right] = [&equation.left, &equation.right].map(|side| terms(side, names));
    let (whole, none) = if right.is_empty() { (left, right) } else { (right, left) };
    if !none.is_empty() {
        return [none, whole];
    }
    let (subtracted, added): (Vec<LinkTerm<'_>>, Vec<LinkTerm<'_>>) = whole.into_iter().partition(|term| term.negative);
    let subtracted = subtracted.into_iter().map(|term| LinkTerm {
        negative: false,
        ..term
    });
    [added, subtracted.collect()]
}

/// A term between two joints.
struct LinkBetween<'a> {
    from: usize,
    to: usize,
    term: LinkTerm<'a>,
    manner: Manner,
}

/// Chains of terms from the origin.
pub(super) struct Chains<'a, 'b> {
    shape: ValueShape,
    names: &'b SkeletonNames<'a>,
    joints: Vec<Joint<'a>>,
    /// Joints by the terms that lead to them, in any order.
    sums: BTreeMap<Vec<String>, usize>,
    links: Vec<LinkBetween<'a>>,
    /// The joints that coincide.
    same: Groups,
}

impl<'a, 'b> Chains<'a, 'b> {
    pub(super) fn new(shape: ValueShape, names: &'b SkeletonNames<'a>) -> Self {
        let mut chains = Self {
            shape,
            names,
            joints: Vec::new(),
            sums: BTreeMap::new(),
            links: Vec::new(),
            same: Groups::default(),
        };
        chains.joint(Vec::new(), None, None);
        chains
    }

    fn joint(&mut self, sum: Vec<String>, before: Option<usize>, term: Option<LinkTerm<'a>>) -> usize {
        let joint = self.same.add();
        self.joints.push(Joint { before, term });
        self.sums.insert(sum, joint);
        joint
    }

    /// The last joint of a chain of terms.
    pub(super) fn chain(&mut self, terms: Vec<LinkTerm<'a>>) -> usize {
        let mut sum = Vec::new();
        let mut last = ORIGIN;
        for term in terms {
            let manner = manner(term.formula, self.shape, self.names);
            last = self.follow(last, &mut sum, term, manner);
        }
        last
    }

    /// The joint behind a further term.
    fn follow(&mut self, from: usize, sum: &mut Vec<String>, term: LinkTerm<'a>, manner: Manner) -> usize {
        extend(sum, &term);
        let to = if let Some(&joint) = self.sums.get(sum) {
            joint
        } else {
            let before = (from != ORIGIN).then_some(from);
            self.joint(sum.clone(), before, Some(term))
        };
        let known = self.links.iter().any(|link| (link.from, link.to) == (from, to));
        if !known {
            self.links.push(LinkBetween { from, to, term, manner });
        }
        to
    }

    /// All joints.
    pub(super) fn into_joints(self) -> Vec<Joint<'a>> {
        self.joints
    }

    /// The joint of an output. Its last terms may lead on within a body that is there; otherwise the point belongs to
    /// none.
    fn point(&mut self, formula: &'a TypedFormula) -> usize {
        let terms = terms(formula, self.names);
        let mut sum = Vec::new();
        let (mut last, mut known) = (ORIGIN, 0);
        for (index, term) in terms.iter().enumerate() {
            extend(&mut sum, term);
            if let Some(&joint) = self.sums.get(&sum) {
                (last, known) = (joint, index + 1);
            }
        }
        let manners: Vec<Manner> = terms
            .iter()
            .map(|term| manner(term.formula, self.shape, self.names))
            .collect();
        let continues = manners.iter().skip(known).all(|manner| match manner {
            Manner::Rigid(turning) => self.rotates_at(turning, last),
            Manner::Sliding { .. } | Manner::Free => false,
        });
        let mut sum = Vec::new();
        for term in terms.iter().take(known) {
            extend(&mut sum, term);
        }
        for (term, manner) in terms.into_iter().zip(manners).skip(known) {
            let manner = if continues { manner } else { Manner::Free };
            last = self.follow(last, &mut sum, term, manner);
        }
        last
    }

    /// Whether a link that rotates like this, or a slide along one, begins or ends at a joint.
    fn rotates_at(&self, turning: &TurningAngles, joint: usize) -> bool {
        let joint = self.same.of(joint);
        self.links.iter().any(|link| match &link.manner {
            Manner::Rigid(known) => {
                known == turning && [link.from, link.to].map(|end| self.same.of(end)).contains(&joint)
            }
            Manner::Sliding { turning: known, .. } => known == turning && self.same.of(link.from) == joint,
            Manner::Free => false,
        }) || turning.is_empty() && joint == ORIGIN
    }

    /// Equal terms from one joint lead to one joint.
    fn unite_consequences(&mut self) {
        let mut changed = true;
        while changed {
            changed = false;
            let mut ends: BTreeMap<(usize, String), usize> = BTreeMap::new();
            for link in &self.links {
                let key = (self.same.of(link.from), link.term.text());
                match ends.get(&key) {
                    Some(&end) => changed |= self.same.unite(end, link.to),
                    None => {
                        ends.insert(key, link.to);
                    }
                }
            }
        }
    }

    fn picture(self, points: Vec<(String, usize)>) -> Picture<'a> {
        let mut parts = Parts::default();
        let ground = parts.at("", ORIGIN);
        for link in &self.links {
            let [from, to] = [link.from, link.to].map(|end| self.same.of(end));
            match &link.manner {
                Manner::Rigid(turning) => {
                    let [one, other] = [from, to].map(|end| parts.at(turning, end));
                    parts.groups.unite(one, other);
                }
                Manner::Sliding { turning, .. } => {
                    parts.at(turning, from);
                }
                Manner::Free => {}
            }
        }
        let ground = parts.groups.of(ground);
        // the slides, each joint on each line once
        let mut slides: Vec<(usize, usize, &LinkBetween<'a>)> = Vec::new();
        for link in &self.links {
            if let Manner::Sliding { turning, .. } = &link.manner {
                let [from, to] = [link.from, link.to].map(|end| self.same.of(end));
                let part = parts.at(turning, from);
                let guide = parts.groups.of(part);
                if !slides.iter().any(|slide| (slide.0, slide.1) == (to, guide)) {
                    slides.push((to, guide, link));
                }
            }
        }
        let shown = self.shown(&parts, ground, &slides, &points);
        let index_of = |joint: usize| shown.iter().position(|&known| known == self.same.of(joint));
        let indices_of = |group: usize| -> Vec<usize> {
            let joints: BTreeSet<usize> = parts.joints_of(group).collect();
            joints.into_iter().filter_map(index_of).collect()
        };
        let mut groups: Vec<usize> = Vec::new();
        for &number in parts.numbers.values() {
            let group = parts.groups.of(number);
            let guides = slides.iter().any(|slide| slide.1 == group);
            if group != ground && !groups.contains(&group) && (guides || indices_of(group).len() > 1) {
                groups.push(group);
            }
        }
        groups.sort_unstable();
        // a fixed joint is calculated from what stands still, however many chains end there
        let calculated = shown.iter().map(|&joint| {
            let mut members = (0..self.joints.len()).filter(|&member| self.same.of(member) == joint);
            members.find(|&member| self.stands_still(member)).unwrap_or(joint)
        });
        let calculated: Vec<usize> = calculated.collect();
        let found = slides.iter().filter_map(|&(joint, guide, link)| {
            let Manner::Sliding { direction, .. } = &link.manner else {
                return None;
            };
            let slide = Slide {
                joint: index_of(joint)?,
                guide: groups.iter().position(|&group| group == guide),
            };
            Some((slide, direction.clone()))
        });
        let (slides, directions): (Vec<Slide>, Vec<SlideDirection>) = found.unzip();
        let bodies = groups.iter().map(|&group| Body {
            name: self.name(&parts, group),
            joints: indices_of(group),
        });
        let points = points
            .into_iter()
            .filter_map(|(name, joint)| Some((name, index_of(joint)?)));
        let mut outline = Outline {
            shape: self.shape,
            joints: calculated.len(),
            ground: indices_of(ground),
            bodies: bodies.collect(),
            slides,
            points: points.collect(),
            scalar_equations: Vec::new(),
            guess: None,
        };
        outline.guess = Some(guess::statements(&outline, &directions, |index| {
            self.written(calculated[index])
        }));
        Picture {
            outline,
            joints: self.joints,
            shown: calculated,
            directions: directions.into_iter().map(|direction| direction.tree).collect(),
        }
    }

    /// A joint as a declaration writes it.
    fn written(&self, joint: usize) -> String {
        let mut terms = Vec::new();
        let mut next = Some(joint);
        while let Some(joint) = next {
            let Joint { before, term } = &self.joints[joint];
            terms.extend(*term);
            next = *before;
        }
        terms.reverse();
        guess::sum(&terms, self.shape, self.names)
    }

    /// Whether no term that leads to a joint varies.
    fn stands_still(&self, mut joint: usize) -> bool {
        loop {
            let Joint { before, term } = &self.joints[joint];
            if term.is_some_and(|term| self.names.varies(term.formula)) {
                return false;
            }
            match before {
                Some(before) => joint = *before,
                None => return true,
            }
        }
    }

    /// Every joint but those within one body, and those that no body shares with the ground.
    fn shown(
        &self,
        parts: &Parts,
        ground: usize,
        slides: &[(usize, usize, &LinkBetween<'a>)],
        points: &[(String, usize)],
    ) -> Vec<usize> {
        let marked: BTreeSet<usize> = slides
            .iter()
            .map(|slide| slide.0)
            .chain(points.iter().map(|&(_, joint)| self.same.of(joint)))
            .collect();
        let is_shown = |joint: usize| {
            let groups: BTreeSet<usize> = parts.groups_at(joint).collect();
            let links: BTreeSet<usize> = self
                .links
                .iter()
                .filter(|link| matches!(link.manner, Manner::Rigid(_)))
                .map(|link| [link.from, link.to].map(|end| self.same.of(end)))
                .filter(|ends| ends.contains(&joint))
                .flatten()
                .collect();
            marked.contains(&joint)
                || groups.len() > 1
                || groups.iter().any(|group| *group != ground) && links.len() <= 2
        };
        (0..self.joints.len())
            .filter(|&joint| self.same.of(joint) == joint && is_shown(joint))
            .collect()
    }

    /// The first length in the terms of a body, or what moves it.
    fn name(&self, parts: &Parts, group: usize) -> String {
        let of_group = |turning: &TurningAngles, joint: usize| {
            parts
                .number(turning, self.same.of(joint))
                .is_some_and(|number| parts.groups.of(number) == group)
        };
        let mut fallback = None;
        for link in &self.links {
            match &link.manner {
                Manner::Rigid(turning) if of_group(turning, link.from) => {
                    if let Some(length) = self.names.length(link.term.formula) {
                        return length;
                    }
                }
                Manner::Sliding { turning, .. } if of_group(turning, link.from) => {
                    fallback = fallback.or_else(|| self.names.motion(link.term.formula));
                }
                _ => {}
            }
        }
        fallback.unwrap_or_else(|| "body".to_owned())
    }
}

/// Adds a term to a sum, whose terms stand in order.
fn extend(sum: &mut Vec<String>, term: &LinkTerm<'_>) {
    let text = term.text();
    let index = sum.partition_point(|other| *other < text);
    sum.insert(index, text);
}

/// Joints with what rotates there: the parts of bodies.
#[derive(Default)]
struct Parts {
    numbers: BTreeMap<(TurningAngles, usize), usize>,
    groups: Groups,
}

impl Parts {
    /// The number of what rotates like this at a joint.
    fn at(&mut self, turning: &str, joint: usize) -> usize {
        let groups = &mut self.groups;
        *self
            .numbers
            .entry((turning.to_owned(), joint))
            .or_insert_with(|| groups.add())
    }

    fn number(&self, turning: &str, joint: usize) -> Option<usize> {
        self.numbers.get(&(turning.to_owned(), joint)).copied()
    }

    /// The joints of a body.
    fn joints_of(&self, group: usize) -> impl Iterator<Item = usize> {
        self.numbers
            .iter()
            .filter(move |&(_, &number)| self.groups.of(number) == group)
            .map(|((_, joint), _)| *joint)
    }

    /// The bodies at a joint.
    fn groups_at(&self, joint: usize) -> impl Iterator<Item = usize> {
        self.numbers
            .iter()
            .filter(move |((_, known), _)| *known == joint)
            .map(|(_, &number)| self.groups.of(number))
    }
}
