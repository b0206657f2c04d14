"""The closed form of a linkage through CasADi, as C."""

import sys

import casadi
from closed_forms import form


def write(linkage, file):
    """Writes a kernel for turns.c."""
    arguments, found = form(linkage, casadi, casadi.SX.sym)
    function = casadi.Function("found", [casadi.vertcat(*arguments)], [casadi.cse(casadi.vertcat(*found))])
    function.generate(file)
    with open(file, "a") as text:
        text.write(
            """
int kernel(const double *in, double *out);
int kernel(const double *in, double *out)
{
    const double *arguments[1] = {in};
    double *results[1] = {out};
    return found(arguments, results, 0, 0, 0);
}
"""
        )


if __name__ == "__main__":
    write(*sys.argv[1:])
