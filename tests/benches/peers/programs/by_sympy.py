"""The closed form of a linkage through SymPy: as C, and with NumPy on whole arrays."""

import sys

import sympy
from closed_forms import LINKAGES, symbols


def form(linkage):
    """The symbols of the arguments, and the expressions of the results."""
    dimensions, crank = symbols(linkage, sympy.Symbol)
    return dimensions + crank, LINKAGES[linkage][0](sympy, dimensions, crank)


def write(linkage, file):
    """Writes a kernel for turns.c."""
    arguments, found = form(linkage)
    shared, results = sympy.cse(found)
    lines = [f"    const double {own} = in[{index}];" for index, own in enumerate(arguments)]
    lines += [f"    const double {own} = {sympy.ccode(value)};" for own, value in shared]
    lines += [f"    out[{index}] = {sympy.ccode(value)};" for index, value in enumerate(results)]
    with open(file, "w") as text:
        text.write("#include <math.h>\n\nint kernel(const double *in, double *out);\n")
        text.write("int kernel(const double *in, double *out)\n{\n")
        text.write("\n".join([*lines, "    return 0;", "}", ""]))


def solver(linkage, _):
    """A function of whole arrays."""
    arguments, found = form(linkage)
    function = sympy.lambdify(arguments, found, modules="numpy", cse=True)
    return lambda columns: function(*columns[: len(arguments)])


if __name__ == "__main__":
    write(*sys.argv[1:])
