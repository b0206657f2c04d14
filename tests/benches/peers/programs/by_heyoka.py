"""The closed form of a linkage through heyoka, which compiles it for whole arrays."""

import heyoka
import numpy as np
from closed_forms import LINKAGES, symbols


def solver(linkage, columns):
    """A function of whole arrays."""
    dimensions, crank = symbols(linkage, heyoka.make_vars)
    found = LINKAGES[linkage][0](heyoka, dimensions, crank)
    arguments = dimensions + crank
    function = heyoka.cfunc([heyoka.expression(own) for own in found], vars=arguments)
    results = np.zeros((len(found), columns.shape[1]))

    def solve(columns):
        function(columns[: len(arguments)], outputs=results)
        return results

    return solve
