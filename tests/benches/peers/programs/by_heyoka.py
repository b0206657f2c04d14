"""The closed form of a linkage through heyoka, which compiles it for whole arrays: as it comes, with sums and products
in any order and without NaN, and in vectors of four numbers as on a machine with AVX2. The dimensions are constants,
because they are the same in all poses."""

import heyoka
import numpy as np
from closed_forms import LINKAGES, form

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
    _, count, _ = LINKAGES[linkage]
    dimensions = [heyoka.expression(own) for own in columns[:count, 0]]
    arguments, found = form(linkage, heyoka, heyoka.make_vars, dimensions)
    function = heyoka.cfunc([heyoka.expression(own) for own in found], vars=arguments, **WAYS[way])
    results = np.zeros((len(found), columns.shape[1]))

    def solve(columns):
        function(columns[count : count + len(arguments)], outputs=results)
        return results

    return solve
