#: The largest exponent for which both the power of two and its reciprocal have full precision.
_EXPONENTS = @RANGE@

#: The outcomes of a factorisation and of Newton's method.
_FOUND, _NOT_CONVERGED, _SINGULAR, _NOT_FINITE = 0, 1, 2, 3

_EPSILON = 2.0**-52


def _clamped(exponents: Array) -> Array:
    return np.clip(exponents, -_EXPONENTS, _EXPONENTS)


def _levelling(largest: Array) -> Array:
    """The exponents of the powers of two that scale numbers to between 2 and 4."""
    return np.where(largest > 0.0, 1 - _clamped(np.frexp(largest)[1] - 1), 1)


class _Factors:
    """The triangular factors of square matrices, one for each pose: multipliers below the diagonal, pivots on it, the
    remaining entries to the right. Rows and columns are scaled by powers of two.

    The axes of `entries` are rows, columns and poses. Where a mask says so, the matrix is scaled as that of other factors.
    `outcome` is one of the constants above for each pose.
    """

    def __init__(self, entries: Array, scaled: "_Factors | None" = None, kept: Array | bool = False) -> None:
        count, _, poses = entries.shape
        finite = np.all(np.isfinite(entries), axis=(0, 1))
        entries = np.where(finite, entries, np.eye(count)[:, :, None])
        rows = _levelling(np.max(np.abs(entries), axis=1))
        rows = rows if scaled is None else np.where(kept, scaled.rows, rows)
        entries = np.ldexp(entries, rows[:, None, :])
        columns = _levelling(np.max(np.abs(entries), axis=0))
        columns = columns if scaled is None else np.where(kept, scaled.columns, columns)
        entries = np.ldexp(entries, columns[None, :, :])
        origins = np.repeat(np.arange(count)[:, None], poses, axis=1)
        largest = np.max(np.abs(entries), axis=(0, 1))
        odd = np.zeros(poses, dtype=bool)
        singular = np.zeros(poses, dtype=bool)
        stopped = np.zeros(poses, dtype=bool)
        every = np.arange(poses)
        for step in range(count):
            best = step + np.argmax(np.abs(entries[step:, step]), axis=0)
            best = np.where(stopped, step, best)
            chosen, replaced = entries[best, :, every].T.copy(), entries[step].copy()
            entries[best, :, every] = replaced.T
            entries[step] = chosen
            chosen_origin, replaced_origin = origins[best, every], origins[step].copy()
            origins[best, every] = replaced_origin
            origins[step] = chosen_origin
            odd ^= best != step
            pivot = entries[step, step]
            size = np.abs(pivot)
            singular |= ~stopped & ~(size > 2.0 * count * _EPSILON * largest)
            stopped |= ~(size > 0.0)
            for row in range(step + 1, count):
                multiplier = np.where(stopped, entries[row, step], entries[row, step] / pivot)
                entries[row, step] = multiplier
                rest = entries[row, step + 1 :] - multiplier * entries[step, step + 1 :]
                entries[row, step + 1 :] = np.where(stopped, entries[row, step + 1 :], rest)
                for entry in entries[row, step + 1 :]:
                    largest = np.where(np.abs(entry) > largest, np.abs(entry), largest)
        self.entries, self.origins, self.rows, self.columns, self.odd = entries, origins, rows, columns, odd
        self.detail = np.where(singular, np.ldexp(self.pivots(), self.exponent()), 0.0)
        self.outcome = np.where(singular, np.where(np.isfinite(self.detail), _SINGULAR, _NOT_FINITE), _FOUND)
        self.outcome = np.where(finite, self.outcome, _NOT_FINITE)

    def pivots(self) -> Array:
        """The product of the pivots, which is the determinant of the scaled matrix."""
        product = np.where(self.odd, -1.0, 1.0)
        for step in range(len(self.entries)):
            product = product * self.entries[step, step]
        return product

    def exponent(self) -> Array:
        """The exponent of the power of two that turns that product into the determinant."""
        return -(np.sum(self.rows, axis=0) + np.sum(self.columns, axis=0))

    def solve(self, right: Array) -> Array:
        """The solution for a right-hand side given in the order of the rows of the matrix."""
        count = len(self.entries)
        scaled = np.take_along_axis(np.ldexp(right, self.rows), self.origins, axis=0)
        solution = np.empty_like(scaled)
        for row in range(count):
            total = scaled[row]
            for column in range(row):
                total = total - self.entries[row, column] * solution[column]
            solution[row] = total
        for row in reversed(range(count)):
            total = solution[row]
            for column in range(row + 1, count):
                total = total - self.entries[row, column] * solution[column]
            solution[row] = total / self.entries[row, row]
        return np.ldexp(solution, self.columns)

    def keep(self, mask: Array) -> None:
        """Leaves out the poses where a mask does not hold."""
        for name, own in vars(self).items():
            setattr(self, name, own[..., mask])
