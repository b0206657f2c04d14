"""The mechanisms of the library, by their names in small letters: `kin.library.four_bar`.

Each is declared when it is first used.

>>> import kin
>>> kin.library.four_bar
<kin.Mechanism FourBar(r1, r2, r3, r4): theta2 -> theta3, theta4>
>>> len(kin.library.names())
37
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from kin._kin import Linkage, Mechanism, library_designs, restored_linkage

_DESIGNS = library_designs()
_declared: dict[str, Mechanism] = {}


def names() -> list[str]:
    """The names of all mechanisms, in the order of the book's table."""
    return list(_DESIGNS)


def mechanism(name: str) -> Mechanism:
    """The mechanism of a name.

    >>> import kin
    >>> kin.library.mechanism("four_bar") is kin.library.four_bar
    True
    """
    if name not in _declared:
        if name not in _DESIGNS:
            raise AttributeError(f"no mechanism of the library is called `{name}`: see kin.library.names()")
        _declared[name] = Mechanism(_DESIGNS[name][0])
    return _declared[name]


def example(name: str) -> tuple[Linkage, dict[str, Any]]:
    """A linkage of a mechanism with dimensions for which it closes, and arguments of `solve` at which it does.

    >>> import kin
    >>> linkage, at = kin.library.example("slider_crank")
    >>> linkage, at["assembly"]
    (SliderCrank(r=1.0, l=3.0), 'open')
    >>> round(linkage.solve(**at).s.position, 6)
    3.372281
    """
    found = mechanism(name)
    _, (parameters, inputs), choice = _DESIGNS[name]
    return restored_linkage(found, parameters), {**dict(zip(found.inputs, inputs)), **choice}


if not TYPE_CHECKING:

    def __getattr__(name: str) -> Mechanism:
        return mechanism(name)


def __dir__() -> list[str]:
    return [*_DESIGNS, "example", "mechanism", "names"]
