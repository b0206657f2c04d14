//! All paths of a homotopy.

use super::ending::{End, EndKind, follow};
use super::homotopy::{Homotopy, Linearised};
use super::traveller::CARE;
use crate::assemblies::Positions;

/// A path, by the choice of factors that are zero at its start, and its end.
#[derive(Clone, Copy, Debug)]
pub(super) struct FollowedPath<const M: usize> {
    choice: usize,
    pub(super) end: End<M>,
}

/// Follows all paths, and those that are lost or suspect once more with more care; says whether in the end none are.
///
/// Of two paths that end at one and the same regular solution one has jumped to the other on its way: through a regular
/// solution there is only one path.
pub(super) fn follow_all<const M: usize, const PATHS: usize>(
    homotopy: &Homotopy<'_, M>,
) -> Positions<FollowedPath<M>, PATHS> {
    let mut at = Linearised::new();
    let mut paths = Positions::new();
    for choice in 0..homotopy.choices() {
        if let Some(end) = follow(homotopy, choice, CARE[0], &mut at) {
            paths.push(FollowedPath { choice, end });
        }
    }
    for care in &CARE[1..] {
        let mut repeated = false;
        for place in 0..paths.len() {
            if suspect(&paths, place) {
                repeated = true;
                let path = &mut paths[place];
                // Where others share the end, they are found suspect in their turn if it does not change.
                path.end = follow(homotopy, path.choice, *care, &mut at).unwrap_or(End::LOST);
            }
        }
        if !repeated {
            break;
        }
    }
    join_singular(&mut paths);
    for place in 0..paths.len() {
        if suspect(&paths, place) {
            paths[place].end = End::LOST;
        }
    }
    paths
}

/// Of the solutions that lie so near each other that rounding decides whether they can be told apart, none is regular
/// unless all are.
fn join_singular<const M: usize>(paths: &mut [FollowedPath<M>]) {
    for place in 0..paths.len() {
        let end = paths[place].end;
        let near = |path: &FollowedPath<M>| path.end.kind == EndKind::Singular && path.end.meets(&end);
        if end.kind == EndKind::Regular && paths.iter().any(near) {
            let end = &mut paths[place].end;
            end.kind = EndKind::Singular;
            end.condition = f64::INFINITY;
        }
    }
}

/// Whether a path was lost, or ends where another one ends although only one can.
fn suspect<const M: usize>(paths: &[FollowedPath<M>], place: usize) -> bool {
    let end = &paths[place].end;
    match end.kind {
        EndKind::Lost => true,
        EndKind::Regular | EndKind::RegularAtInfinity => paths
            .iter()
            .enumerate()
            .any(|(other, path)| other != place && path.end.kind == end.kind && path.end.meets(end)),
        EndKind::Singular | EndKind::AtInfinity => false,
    }
}
