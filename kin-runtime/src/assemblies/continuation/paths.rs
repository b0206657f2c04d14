//! All paths of a homotopy.

use super::ending::{PathEnd, PathEndKind, follow};
use super::homotopy::{Homotopy, Linearised};
use super::traveller::CARE;
use crate::assemblies::Positions;

/// A path and its end. The path is given by the choice of factors that are zero at its start.
#[derive(Clone, Copy, Debug)]
pub(super) struct FollowedPath<const M: usize> {
    choice: usize,
    pub(super) end: PathEnd<M>,
}

/// Follows all paths. Paths that are lost or suspect are followed again with greater care. Paths that remain suspect
/// count as lost.
///
/// If two paths end at the same regular solution, one of them has jumped to the other, because only one path passes
/// through a regular solution.
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
        for index in 0..paths.len() {
            if suspect(&paths, index) {
                repeated = true;
                let path = &mut paths[index];
                // If other paths share this end and it does not change, they are suspect as well.
                path.end = follow(homotopy, path.choice, *care, &mut at).unwrap_or(PathEnd::LOST);
            }
        }
        if !repeated {
            break;
        }
    }
    join_singular(&mut paths);
    for index in 0..paths.len() {
        if suspect(&paths, index) {
            paths[index].end = PathEnd::LOST;
        }
    }
    paths
}

/// Makes regular ends singular that meet a singular one: the two are so close that rounding decides whether they
/// differ.
fn join_singular<const M: usize>(paths: &mut [FollowedPath<M>]) {
    for index in 0..paths.len() {
        let end = paths[index].end;
        let near = |path: &FollowedPath<M>| path.end.kind == PathEndKind::Singular && path.end.meets(&end);
        if end.kind == PathEndKind::Regular && paths.iter().any(near) {
            let end = &mut paths[index].end;
            end.kind = PathEndKind::Singular;
            end.condition = f64::INFINITY;
        }
    }
}

/// Whether a path was lost, or ends where another one ends although only one can.
fn suspect<const M: usize>(paths: &[FollowedPath<M>], index: usize) -> bool {
    let end = &paths[index].end;
    match end.kind {
        PathEndKind::Lost => true,
        PathEndKind::Regular | PathEndKind::RegularAtInfinity => paths
            .iter()
            .enumerate()
            .any(|(other, path)| other != index && path.end.kind == end.kind && path.end.meets(end)),
        PathEndKind::Singular | PathEndKind::AtInfinity => false,
    }
}
