"""The closed form of a linkage through CasADi, as C: with the dimensions as arguments, or as the constants of the first
row."""

import sys

import casadi
import numpy as np
from closed_forms import LINKAGES, form


def write(linkage, file, *way):
    """Writes a kernel for turns.c."""
    count = LINKAGES[linkage][1] if way == ("constant",) else 0
    dimensions = [float(own) for own in np.fromfile("in", dtype="<f8", count=count)]
    arguments, found = form(linkage, casadi, casadi.SX.sym, dimensions)
    function = casadi.Function("found", [casadi.vertcat(*arguments)], [casadi.cse(casadi.vertcat(*found))])
    function.generate(file)
    with open(file, "a") as text:
        text.write(
            f"""
int kernel(const double *in, double *out);
int kernel(const double *in, double *out)
{{
    const double *arguments[1] = {{in + {count}}};
    double *results[1] = {{out}};
    return found(arguments, results, 0, 0, 0);
}}
"""
        )


if __name__ == "__main__":
    write(*sys.argv[1:])
