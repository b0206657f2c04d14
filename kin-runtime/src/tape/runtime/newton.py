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


class _Search:
    """Newton's method for a block, for the poses that have not ended."""

    def __init__(self, guess: Array, sizes: Array, equations: Callable[..., tuple[Array, Array]], given: Array) -> None:
        self.equations, self.sizes, self.given = equations, sizes, given
        poses = guess.shape[1]
        self.root = guess.copy()
        self.outcome = np.full(poses, _NOT_CONVERGED)
        self.detail = np.zeros(poses)
        #: The places of the poses that have not ended.
        self.left = np.arange(poses)

    def at(self, unknowns: Array) -> tuple[Array, Array, Array]:
        """Residuals, Jacobian, and whether they are finite."""
        residuals, jacobian = self.equations(unknowns, *self.given)
        jacobian = jacobian * self.sizes
        finite = np.all(np.isfinite(residuals), axis=0) & np.all(np.isfinite(jacobian), axis=(0, 1))
        return residuals, jacobian, finite

    def end(self, mask: Array, outcome: Array | int, detail: Array | float) -> None:
        places = self.left[mask]
        self.outcome[places] = np.broadcast_to(outcome, mask.shape)[mask]
        self.detail[places] = np.broadcast_to(detail, mask.shape)[mask]

    def distinct(self, mask: Array, root: Array, previous: _Factors | None, factors: _Factors) -> None:
        """Accepts roots, unless a change of the size of rounding errors alters the determinant by a quarter of itself."""
        ratio = np.ones(mask.shape)
        if previous is not None:
            exponent = _clamped(factors.exponent() - previous.exponent())
            ratio = np.ldexp(factors.pivots() / previous.pivots(), exponent)
        right = (ratio >= 0.75) & (ratio <= 1.25)
        determinant = np.where(right, 0.0, np.ldexp(factors.pivots(), factors.exponent()))
        finite = np.where(right, np.all(np.isfinite(root), axis=0), np.isfinite(determinant))
        self.root[:, self.left[mask]] = root[:, mask]
        self.end(mask, np.where(finite, np.where(right, _FOUND, _SINGULAR), _NOT_FINITE), determinant)

    def keep(self, mask: Array) -> None:
        self.left, self.sizes, self.given = self.left[mask], self.sizes[:, mask], self.given[:, mask]


def _newton(
    guess: Array, sizes: Array, equations: Callable[..., tuple[Array, Array]], given: Array, wanted: Array
) -> tuple[Array, Array, Array]:
    """The roots of a block near a guess, by Newton's method with the damping of P. Deuflhard, Newton Methods for
    Nonlinear Problems, Springer 2004, section 3.3.3.

    The last axis of all arrays are the poses, of which the `wanted` ones are solved. `sizes` are the natural sizes of the
    unknowns; `equations` gives the residuals and their Jacobian, one row for each equation, at unknowns and the `given`
    numbers. Returned are the roots, the outcome of each pose, and the residual of an iteration that does not converge or
    the determinant of a singular Jacobian.
    """
    search = _Search(guess, sizes, equations, given)
    unknowns = guess
    residuals, jacobian, finite = search.at(unknowns)
    finite = finite & np.all((sizes > 0.0) & np.isfinite(sizes), axis=0)
    search.end(~finite, _NOT_FINITE, 0.0)
    pending = finite & wanted
    previous, before, part, expected = np.zeros(len(pending)), None, np.ones(len(pending)), guess
    tested, kept = np.ones(len(pending), dtype=bool), np.zeros(len(pending), dtype=bool)
    limit = np.full(len(pending), @FIRST_STEP@)
    for iteration in range(@ITERATIONS@ + 1):
        # Poses that have ended are left out.
        search.keep(pending)
        unknowns, residuals, jacobian = unknowns[:, pending], residuals[:, pending], jacobian[:, :, pending]
        previous, part, expected, limit = previous[pending], part[pending], expected[:, pending], limit[pending]
        tested, kept = tested[pending], kept[pending]
        if before is not None:
            before.keep(pending)
        if len(search.left) == 0:
            break
        # Scales are kept after a step that has hardly changed the Jacobian.
        factors = _Factors(jacobian, before, kept)
        broken = factors.outcome != _FOUND
        search.end(broken, factors.outcome, factors.detail)
        if iteration == @ITERATIONS@:
            search.end(~broken, _NOT_CONVERGED, _largest(residuals))
            break
        correction = -factors.solve(residuals)
        length = _largest(correction)
        lengthy = ~broken & ~np.isfinite(length)
        search.end(lengthy, _NOT_CONVERGED, _largest(residuals))
        pending = ~broken & ~lengthy
        size = np.maximum(search.sizes, np.abs(unknowns))
        lost = pending & np.all(np.abs(correction) * search.sizes <= _EPSILON * size, axis=0)
        # How the correction compares with the one before, if that was taken in full.
        contraction = np.full(len(pending), np.inf)
        if before is not None:
            contraction = np.where(part == 1.0, length / previous, np.inf)
        # The next correction would disappear.
        quadratic, next_length = contraction <= @QUADRATIC@, contraction * contraction * length
        foretold = pending & quadratic & (next_length <= @NEGLIGIBLE@ * _EPSILON)
        # Whether the next correction may be a simplified one, by these factors, and is the last.
        last = quadratic & (2.0 * contraction * contraction * next_length <= @NEGLIGIBLE@ * _EPSILON)
        search.distinct(foretold, unknowns + correction * search.sizes, None, factors)
        pending, lost = pending & ~foretold, lost & ~foretold
        rounding = _is_rounding(length, unknowns, jacobian, search.sizes, factors)
        stalled = np.zeros_like(lost)
        if before is not None:
            stalled = pending & ~lost & (part == 1.0) & (length >= 0.5 * previous) & rounding
        search.distinct(lost, unknowns + correction * search.sizes, before, factors)
        search.distinct(stalled, unknowns, before, factors)
        pending = pending & ~lost & ~stalled
        converging = contraction <= @CONVERGING@
        foreseen = np.ones(len(pending))
        if before is not None:
            foreseen = part * previous * _largest(expected) / (_largest(expected - correction) * length)
            shortens = tested & ~converging & (foreseen < 1.0)
            foreseen = np.where(shortens, np.maximum(foreseen, @SMALLEST_PART@), 1.0)
        part = np.minimum(foreseen, limit / length)

        trying, next_unknowns = pending, unknowns
        next_residuals, next_jacobian = residuals, jacobian
        for _ in range(@TRIALS@):
            if not np.any(trying):
                break
            trial = unknowns + part * correction * search.sizes
            advice = 0.5 * part
            there_residuals, there_jacobian, finite = search.at(trial)
            forecast = -factors.solve(there_residuals)
            fall = _largest(forecast) / length
            # A correction that has fallen enough shows that the full step is in order.
            untested = converging & (part == 1.0)
            ended = trying & finite & untested & last & (_largest(forecast) <= @QUADRATIC@ * length)
            search.distinct(ended, trial + forecast * search.sizes, None, factors)
            trying, pending = trying & ~ended, pending & ~ended
            accepted = trying & finite & (untested | (fall < 1.0 - 0.25 * part))
            tested = np.where(accepted, ~untested, tested)
            kept = np.where(accepted, untested | (fall <= @CONVERGING@), kept)
            next_unknowns = np.where(accepted, trial, next_unknowns)
            expected = np.where(accepted, forecast, expected)
            next_residuals = np.where(accepted, there_residuals, next_residuals)
            next_jacobian = np.where(accepted, there_jacobian, next_jacobian)
            trying = trying & ~accepted
            rounded = trying & finite & rounding
            if np.any(rounded):
                there = _Factors(there_jacobian)
                broken = rounded & (there.outcome != _FOUND)
                search.end(broken, there.outcome, there.detail)
                search.distinct(rounded & ~broken, np.where(fall < 1.0, trial, unknowns), factors, there)
                trying, pending = trying & ~rounded, pending & ~rounded
            estimate = 0.5 * length * part * part / _largest(forecast - (1.0 - part) * correction)
            # Shorten to a tenth at most: the estimate is rough if the step was much too long.
            shorter = finite & (estimate < advice)
            advice = np.where(shorter, np.maximum(estimate, 0.1 * part), advice)
            part = np.where(trying, advice, part)
        search.end(trying, _NOT_CONVERGED, _largest(residuals))
        pending = pending & ~trying
        # If the equations are nearly linear over a step, the next step may be longer.
        linear = _largest(expected - (1.0 - part) * correction) <= 0.25 * part * length
        limit = np.where(tested & linear, limit * 2.0, limit)
        previous, before = length, factors
        unknowns, residuals, jacobian = next_unknowns, next_residuals, next_jacobian
    return search.root, search.outcome, search.detail
