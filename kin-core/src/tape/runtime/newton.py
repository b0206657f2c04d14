def _largest(vector: Array) -> Array:
    """The largest magnitude, or NaN if an entry is NaN."""
    return np.max(np.abs(vector), axis=0)


def _is_rounding(length: Array, unknowns: Array, jacobian: Array, sizes: Array, factors: _Factors) -> Array:
    """Whether rounding may explain a correction that does not fall."""
    count = len(unknowns)
    sums = np.zeros_like(unknowns)
    for column in range(count):
        unit = np.zeros_like(unknowns)
        unit[column] = 1.0
        weight = np.zeros_like(length)
        for entry in jacobian[column]:
            weight = weight + np.abs(entry)
        sums = sums + np.abs(factors.solve(unit)) * weight
    size = np.maximum(1.0, np.max(np.abs(unknowns) / sizes, axis=0))
    # A sum that is not a number does not count.
    amplification = np.fmax(0.0, np.fmax.reduce(sums, axis=0))
    linear = length * length <= @LINEAR_STEP@ * _EPSILON
    return linear | (length <= 16.0 * _EPSILON * size * amplification)


def _newton(
    guess: Array, sizes: Array, equations: Callable[[Array], tuple[Array, Array]], poses: int
) -> tuple[Array, Array, Array]:
    """The roots of a block near a guess, by Newton's method with the damping of P. Deuflhard, Newton Methods for
    Nonlinear Problems, Springer 2004, section 3.3.3.

    The last axis of all arrays are the poses. `sizes` are the natural sizes of the unknowns; `equations` gives the
    residuals and their Jacobian, one row for each equation. Returned are the roots, the outcome of each pose, and the
    residual of an iteration that does not converge or the determinant of a singular Jacobian.
    """
    guess = np.broadcast_to(guess, (len(guess), poses)).astype(np.float64)
    sizes = np.broadcast_to(sizes, (len(sizes), poses)).astype(np.float64)
    root = guess.copy()
    outcome = np.full(poses, _NOT_CONVERGED)
    detail = np.zeros(poses)
    pending = np.all((sizes > 0.0) & np.isfinite(sizes), axis=0)

    def at(unknowns: Array) -> tuple[Array, Array, Array]:
        residuals, jacobian = equations(unknowns)
        jacobian = jacobian * sizes
        finite = np.all(np.isfinite(residuals), axis=0) & np.all(np.isfinite(jacobian), axis=(0, 1))
        return residuals, jacobian, finite

    def end(mask: Array, code: Array | int, number: Array | float) -> None:
        nonlocal pending, outcome, detail
        outcome = np.where(mask, code, outcome)
        detail = np.where(mask, number, detail)
        pending = pending & ~mask

    def distinct(mask: Array, place: Array, previous: _Factors | None, pivots: _Factors, started: bool | Array) -> None:
        """Accepts roots, unless a change of the size of rounding errors alters the determinant by a quarter."""
        nonlocal root
        ratio = np.ones(poses)
        if previous is not None:
            exponent = _clamped(pivots.exponent() - previous.exponent())
            ratio = np.where(started, np.ldexp(pivots.pivots() / previous.pivots(), exponent), 1.0)
        right = (ratio >= 0.75) & (ratio <= 1.25)
        determinant = np.where(right, 0.0, np.ldexp(pivots.pivots(), pivots.exponent()))
        finite = np.where(right, np.all(np.isfinite(place), axis=0), np.isfinite(determinant))
        root = np.where(mask, place, root)
        end(mask, np.where(finite, np.where(right, _FOUND, _SINGULAR), _NOT_FINITE), determinant)

    unknowns = guess.copy()
    residuals, jacobian, finite = at(unknowns)
    pending = pending & finite
    outcome = np.where(pending, outcome, _NOT_FINITE)
    factors = _Factors(jacobian)
    end(pending & (factors.outcome != _FOUND), factors.outcome, factors.detail)
    before: _Factors | None = None
    limit = np.full(poses, @FIRST_STEP@)
    part, previous, expected = np.ones(poses), np.zeros(poses), np.zeros_like(guess)
    for _ in range(@ITERATIONS@):
        if not np.any(pending):
            break
        correction = -factors.solve(residuals)
        length = _largest(correction)
        end(pending & ~np.isfinite(length), _NOT_CONVERGED, _largest(residuals))
        size = np.maximum(1.0, np.abs(unknowns) / sizes)
        lost = pending & np.all(np.abs(correction) <= _EPSILON * size, axis=0)
        rounding = _is_rounding(length, unknowns, jacobian, sizes, factors)
        stalled = np.zeros(poses, dtype=bool)
        if before is not None:
            stalled = pending & ~lost & (part == 1.0) & (length >= 0.5 * previous) & rounding
        place = np.where(lost, unknowns + 1.0 * correction * sizes, unknowns)
        distinct(lost | stalled, place, before, factors, before is not None)
        foreseen = np.ones(poses)
        if before is not None:
            foreseen = part * previous * _largest(expected) / (_largest(expected - correction) * length)
            foreseen = np.where(foreseen < 1.0, np.maximum(foreseen, @SMALLEST_PART@), 1.0)
        part = np.minimum(foreseen, limit / length)

        # The places that are accepted, one after the other.
        trying, moved = pending.copy(), unknowns.copy()
        moved_residuals, moved_jacobian = residuals.copy(), jacobian.copy()
        for _ in range(@TRIALS@):
            if not np.any(trying):
                break
            trial = unknowns + part * correction * sizes
            advice = 0.5 * part
            there_residuals, there_jacobian, finite = at(trial)
            forecast = -factors.solve(there_residuals)
            fall = _largest(forecast) / length
            accepted = trying & finite & (fall < 1.0 - 0.25 * part)
            moved = np.where(accepted, trial, moved)
            expected = np.where(accepted, forecast, expected)
            moved_residuals = np.where(accepted, there_residuals, moved_residuals)
            moved_jacobian = np.where(accepted, there_jacobian, moved_jacobian)
            trying = trying & ~accepted
            rounded = trying & finite & rounding
            if np.any(rounded):
                there = _Factors(there_jacobian)
                place = np.where(fall < 1.0, trial, unknowns)
                broken = rounded & (there.outcome != _FOUND)
                end(broken, there.outcome, there.detail)
                distinct(rounded & ~broken, place, factors, there, True)
                trying = trying & ~rounded
            estimate = 0.5 * length * part * part / _largest(forecast - (1.0 - part) * correction)
            # Shorten to a tenth at most: the estimate is rough if the step was much too long.
            shorter = finite & (estimate < advice)
            advice = np.where(shorter, np.maximum(estimate, 0.1 * part), advice)
            part = np.where(trying, advice, part)
        end(trying, _NOT_CONVERGED, _largest(residuals))
        # If the equations are nearly linear over a step, the next step may be longer.
        linear = _largest(expected - (1.0 - part) * correction) <= 0.25 * part * length
        limit = np.where(linear, limit * 2.0, limit)
        previous, before = length, factors
        unknowns, residuals, jacobian = moved, moved_residuals, moved_jacobian
        factors = _Factors(jacobian)
        end(pending & (factors.outcome != _FOUND), factors.outcome, factors.detail)
    end(pending, _NOT_CONVERGED, _largest(residuals))
    return root, outcome, detail
