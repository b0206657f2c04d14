"""The closed form of a linkage through heyoka, which compiles it for whole arrays: as it comes, with sums and products
in any order and without NaN, and in vectors of four numbers as on a machine with AVX2."""

import heyoka
import numpy as np
from closed_forms import form

# Many poses would otherwise be shared out among all cores.
heyoka.set_nthreads(1)

WAYS = {
    "batch": {},
    "batch.fast": {"fast_math": True},
    "batch.avx2": {"batch_size": 4},
    "batch.avx2.fast": {"batch_size": 4, "fast_math": True},
}


def solver(linkage, columns, way):
    """A function of whole arrays."""
    arguments, found = form(linkage, heyoka, lambda name: heyoka.make_vars(name))
    function = heyoka.cfunc([heyoka.expression(own) for own in found], vars=arguments, **WAYS[way])
    results = np.zeros((len(found), columns.shape[1]))

    def solve(columns):
        function(columns[: len(arguments)], outputs=results)
        return results

    return solve
