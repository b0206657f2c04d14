"""The closed form of a linkage through SymPy, as C."""

import sys

import sympy
from closed_forms import form


def write(linkage, file):
    """Writes a kernel for turns.c."""
    arguments, found = form(linkage, sympy, sympy.Symbol)
    shared, results = sympy.cse(found)
    lines = [f"    const double {own} = in[{index}];" for index, own in enumerate(arguments)]
    lines += [f"    const double {own} = {sympy.ccode(value)};" for own, value in shared]
    lines += [f"    out[{index}] = {sympy.ccode(value)};" for index, value in enumerate(results)]
    with open(file, "w") as text:
        text.write("#include <math.h>\n\nint kernel(const double *in, double *out);\n")
        text.write("int kernel(const double *in, double *out)\n{\n")
        text.write("\n".join([*lines, "    return 0;", "}", ""]))


if __name__ == "__main__":
    write(*sys.argv[1:])
