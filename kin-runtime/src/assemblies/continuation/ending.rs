//! The ends of paths.

use super::complex::Complex;
use super::homotopy::{Homotopy, Linearised};
use super::traveller::{Advance, Care, Pinned, Traveller};

/// The distance from the end at which a path is checked for a singular end.
const NEAR_END: f64 = 0.1;
/// The distance within which a path that has not arrived is assumed to wind around a singular end.
const NEARER: f64 = 1e-3;
/// The distance below which rounding dominates.
const NEAREST: f64 = 1e-13;
/// The largest residual at a singular end. Rounding alone is some orders of magnitude smaller.
const SOLVED: f64 = 1e-12;
/// The largest residual if no better end is found: this one belongs to the mean of two solutions that are too close to
/// separate.
const NEARLY_SOLVED: f64 = 1e-8;
/// The factor for the distance between regular solutions: they lie further apart than this many times their errors.
const CLEARANCE: f64 = 64.0;
/// The distance within which singular ends count as one, as does any end so close to one that rounding may cause the
/// difference. Rounding the coefficients by ε moves a double solution by √ε times a condition number.
const TOGETHER: f64 = 1e-4;
/// A bound on what rounding leaves of the imaginary part of a singular end, or of X₀ of an end at infinity.
const NOTHING: f64 = 1e-6;
/// The shortest allowed last step to a regular solution that has another solution close to it.
const SHORTEST_LAST_STEP: f64 = 1e-16;
/// The number of points on a loop around the end.
const POINTS: u8 = 8;
/// The largest number of loops after which a path closes.
const MOST_LOOPS: u8 = 12;

/// The end of a path.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathEnd<const M: usize> {
    /// The kind of end.
    pub(super) kind: PathEndKind,
    /// Numbers that distinguish it from other ends, in projective space.
    pub(super) marks: [Complex; 2],
    /// The error of the marks.
    pub(super) error: f64,
    /// The variables, if they are real.
    pub(super) values: Option<[f64; M]>,
    /// The condition of the solution: the factor by which relative rounding errors of the terms are magnified.
    pub(super) condition: f64,
}

/// The kinds of ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PathEndKind {
    /// A solution with a regular Jacobian; no other path ends here.
    Regular,
    /// A solution with a singular Jacobian.
    Singular,
    /// A point at infinity where no other path ends.
    RegularAtInfinity,
    /// A point at infinity.
    AtInfinity,
    /// The path could not be followed to its end.
    Lost,
}

impl<const M: usize> PathEnd<M> {
    pub(super) const LOST: Self = Self {
        kind: PathEndKind::Lost,
        marks: [Complex::ZERO; 2],
        error: 0.0,
        values: None,
        condition: 0.0,
    };

    /// Whether two paths end at the same point, within their errors.
    pub(super) fn meets(&self, other: &Self) -> bool {
        let [first, second] = [0, 1].map(|mark| (self.marks[mark] - other.marks[mark]).norm());
        let size = self.marks.iter().fold(1.0_f64, |most, mark| most.max(mark.norm()));
        first.max(second) <= (self.error + other.error) * size * size
    }
}

/// A solution of the system, in the free coordinates.
struct Settled<const M: usize> {
    point: [Complex; M],
    condition: f64,
    error: f64,
}

/// Follows one path from its start to its end; `None` if there is no such path.
pub(super) fn follow<const M: usize>(
    homotopy: &Homotopy<'_, M>,
    choice: usize,
    care: Care,
    at: &mut Linearised<M>,
) -> Option<PathEnd<M>> {
    let traveller = Traveller::depart(homotopy.clone(), choice, at)?;
    Some(travel(traveller, care, at))
}

fn travel<const M: usize>(mut traveller: Traveller<'_, M>, care: Care, at: &mut Linearised<M>) -> PathEnd<M> {
    if traveller.advance(Complex::real(NEAR_END), 1e-10, true, care, at) != Advance::Arrived {
        return PathEnd::LOST;
    }
    // Most ends are regular and can be reached directly.
    let mut ahead = traveller.clone();
    if let Some(end) = walk(&mut ahead, 0.5 * NEARER, care, at) {
        return end;
    }
    if ahead.t != Complex::ZERO {
        traveller = ahead;
    }
    limit(&mut traveller, care, at)
}

/// The end of a path, if it is regular and can be reached by steps no shorter than the given one.
fn walk<const M: usize>(
    traveller: &mut Traveller<'_, M>,
    shortest: f64,
    care: Care,
    at: &mut Linearised<M>,
) -> Option<PathEnd<M>> {
    if traveller.advance(Complex::ZERO, shortest, true, care, at) != Advance::Arrived {
        return None;
    }
    let settled = settle(&traveller.homotopy, traveller.point, at)?;
    Some(regular_end(&traveller.homotopy, &settled, at))
}

/// The end of a path that winds around a singular solution or around one at infinity.
///
/// At such an end Y is a power series of t^(1/c) with a natural number c, the winding number. After c loops around t =
/// 0 the path closes, and the mean over the loops is its end (Cauchy's integral; A. P. Morgan, A. J. Sommese & C. W.
/// Wampler, *Computing singular solutions to nonlinear analytic systems*, Numerische Mathematik 58, 1991). With N
/// points on each loop of radius r, the mean has an error proportional to r^N. Two radii therefore show whether the
/// series converges, and how well.
fn limit<const M: usize>(traveller: &mut Traveller<'_, M>, care: Care, at: &mut Linearised<M>) -> PathEnd<M> {
    let mut radius = traveller.t.re;
    let mut before: Option<([Complex; M], u8)> = None;
    let mut candidate = None;
    while radius > NEAREST {
        if traveller.advance(Complex::real(radius), 1e-5 * radius, false, care, at) != Advance::Arrived {
            break;
        }
        // A coordinate that vanishes at the end must not be pinned: the others would have a pole there, but still a
        // mean.
        match traveller.pin(at) {
            Pinned::Same => {}
            Pinned::Other => before = None,
            Pinned::Singular => break,
        }
        let mean = mean_of_loops(traveller, radius, care, at);
        if let (Some((mean, loops)), Some((earlier, earlier_loops))) = (mean, before)
            && loops == earlier_loops
        {
            let change = distance(&traveller.homotopy, &mean, &earlier);
            // A loop around several branch points has a mean too, but this mean is not a solution.
            let residual = traveller.homotopy.residual(&mean, at);
            if change <= 1e-6 && residual <= NEARLY_SOLVED {
                // The second mean is better than the first by a power of the ratio of the radii.
                candidate = Some((traveller.homotopy.clone(), mean, (1e-4 * change).max(1e-10)));
                if residual <= SOLVED {
                    break;
                }
            }
        }
        before = mean;
        radius *= 0.25;
    }
    let end = candidate.map(|(homotopy, mean, error)| end_at(&homotopy, mean, error, at));
    match end {
        Some(end) if end.kind != PathEndKind::Singular => end,
        // Two solutions can be so close that their mean is nearly a solution. Then the path leads to one of the two.
        _ => walk(traveller, SHORTEST_LAST_STEP, care, at)
            .or(end)
            .unwrap_or(PathEnd::LOST),
    }
}

/// The mean of a path over the loops after which it closes, and the number of these loops.
fn mean_of_loops<const M: usize>(
    traveller: &Traveller<'_, M>,
    radius: f64,
    care: Care,
    at: &mut Linearised<M>,
) -> Option<([Complex; M], u8)> {
    let free = traveller.homotopy.free();
    let mut around = traveller.clone();
    let mut sum = [Complex::ZERO; M];
    let mut farthest = 0.0;
    for loops in 1..=MOST_LOOPS {
        for point in 1..=POINTS {
            let target = if point == POINTS {
                Complex::real(radius)
            } else {
                let angle = core::f64::consts::TAU * f64::from(point) / f64::from(POINTS);
                Complex::unit(angle).scale(radius)
            };
            if around.advance(target, 1e-5 * radius, false, care, at) != Advance::Arrived {
                return None;
            }
            for (sum, value) in sum[..free].iter_mut().zip(&around.point) {
                *sum += *value;
            }
            let distance = distance(&traveller.homotopy, &around.point, &traveller.point);
            if point == POINTS && distance <= 1e-9 + 1e-4 * farthest {
                let count = f64::from(POINTS) * f64::from(loops);
                return Some((sum.map(|sum| sum.scale(1.0 / count)), loops));
            }
            farthest = distance.max(farthest);
        }
    }
    None
}

impl<const M: usize> Homotopy<'_, M> {
    /// The residual of the equations at t = 0. Their coefficients are at most one, and the coordinates are about one.
    fn residual(&self, point: &[Complex; M], at: &mut Linearised<M>) -> f64 {
        self.evaluate(point, Complex::ZERO, at);
        let magnitudes = self.magnitudes(point);
        for (value, magnitude) in at.value[..self.free()].iter_mut().zip(magnitudes) {
            *value = value.scale(1.0 / magnitude.max(1.0));
        }
        self.size(&at.value)
    }
}

fn distance<const M: usize>(homotopy: &Homotopy<'_, M>, first: &[Complex; M], second: &[Complex; M]) -> f64 {
    let mut difference = *first;
    for (value, other) in difference.iter_mut().zip(second) {
        *value = *value - *other;
    }
    homotopy.size(&difference)
}

/// The kind of end at the limit of a path.
fn end_at<const M: usize>(
    homotopy: &Homotopy<'_, M>,
    mean: [Complex; M],
    error: f64,
    at: &mut Linearised<M>,
) -> PathEnd<M> {
    if let Some(settled) = settle(homotopy, mean, at)
        && distance(homotopy, &settled.point, &mean) <= 1e2 * (error + settled.error)
    {
        return regular_end(homotopy, &settled, at);
    }
    let (x, infinity) = homotopy.homogeneous(&mean);
    let free = homotopy.free();
    let at_infinity = infinity.norm() <= NOTHING;
    let real = mean[..free].iter().all(|value| value.im.abs() <= NOTHING);
    PathEnd {
        kind: if at_infinity {
            PathEndKind::AtInfinity
        } else {
            PathEndKind::Singular
        },
        marks: homotopy.marks(&mean),
        error: TOGETHER,
        values: (real && !at_infinity).then(|| {
            let inverse = infinity.inverse();
            x.map(|x| (x * inverse).re)
        }),
        condition: f64::INFINITY,
    }
}

/// Newton's method to the last digit at t = 0. `None` if the Jacobian is singular, or practically singular.
fn settle<const M: usize>(
    homotopy: &Homotopy<'_, M>,
    mut point: [Complex; M],
    at: &mut Linearised<M>,
) -> Option<Settled<M>> {
    let free = homotopy.free();
    let mut step = f64::INFINITY;
    for _ in 0..6 {
        let next = homotopy.newton(&mut point, Complex::ZERO, at)?;
        if next.is_nan() || next > 1e-2 {
            return None;
        }
        if next >= 0.5 * step || next == 0.0 {
            step = next;
            break;
        }
        step = next;
    }
    // The effect of rounding in the terms on the solution: the rows of the inverse, weighted by the terms.
    let magnitudes = homotopy.magnitudes(&point);
    let mut sums = [0.0; M];
    let mut longest = ([Complex::ZERO; M], 0.0);
    for row in 0..free {
        let mut column = [Complex::ZERO; M];
        column[row] = Complex::real(magnitudes[row]);
        at.factors.solve(free, &mut column);
        for (sum, entry) in sums[..free].iter_mut().zip(&column) {
            *sum += entry.norm();
        }
        let length = homotopy.size(&column);
        if length > longest.1 {
            longest = (column, length);
        }
    }
    let condition = sums[..free].iter().fold(1.0, |most: f64, &sum| most.max(sum));
    let error = 4.0 * f64::EPSILON * condition;
    if step > 4.0 * error || error > 1e-3 {
        return None;
    }
    // Test whether another solution is so close that rounding might lead to it. Newton's method must return from a
    // start far beyond the error, in the direction in which the error is largest.
    let (direction, length) = longest;
    let aside = CLEARANCE * error;
    let mut probe = point;
    if length > 0.0 {
        for (value, along) in probe[..free].iter_mut().zip(&direction) {
            *value += along.scale(aside / length);
        }
        homotopy.newton(&mut probe, Complex::ZERO, at)?;
    }
    // From a distance h, with another solution at the distance s, the step ends at a distance of h² / 2(s + h).
    (distance(homotopy, &probe, &point) <= 0.125 * aside + 4.0 * error).then_some(Settled {
        point,
        condition,
        error,
    })
}

fn regular_end<const M: usize>(homotopy: &Homotopy<'_, M>, settled: &Settled<M>, at: &mut Linearised<M>) -> PathEnd<M> {
    let &Settled {
        mut point,
        condition,
        error,
    } = settled;
    let free = homotopy.free();
    let marks = homotopy.marks(&point);
    let (_, infinity) = homotopy.homogeneous(&point);
    let mut end = PathEnd {
        kind: PathEndKind::Regular,
        marks,
        error: 4.0 * error,
        values: None,
        condition,
    };
    if infinity.norm() <= 16.0 * error {
        end.kind = PathEndKind::RegularAtInfinity;
        return end;
    }
    // The coordinates are real linear forms of the variables, and one coordinate is one: if the variables are real, all
    // coordinates are real. Other solutions come in pairs with their conjugates, at a distance of at least 1 /
    // condition.
    if point[..free].iter().all(|value| value.im.abs() <= 4.0 * error) {
        for value in &mut point {
            value.im = 0.0;
        }
        // With real coordinates all numbers are real, including those of Newton's method.
        if homotopy
            .newton(&mut point, Complex::ZERO, at)
            .is_some_and(|step| step <= 16.0 * error)
        {
            let (x, infinity) = homotopy.homogeneous(&point);
            let inverse = 1.0 / infinity.re;
            end.values = Some(x.map(|x| x.re * inverse));
        } else {
            return PathEnd::LOST;
        }
    }
    end
}
