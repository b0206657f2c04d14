def _named(what: str, given: Mapping, names: Sequence[str]) -> None:
    """Refuses a dictionary in which a name is missing, or is none of these."""
    for name in given:
        if name not in names:
            raise TypeError(f"{what} has no {name!r}: its names are {', '.join(names) or 'none'}")
    for name in names:
        if name not in given:
            raise TypeError(f"{what} has no value for {name!r}")


def _moving(name: str, motion: Sequence[npt.ArrayLike]) -> None:
    """Refuses what is no list of a position and its rates."""
    try:
        count = len(motion)
    except TypeError:
        count = 0
    if isinstance(motion, str) or not 1 <= count <= @ENTRIES@:
        told = f"has {count} entries" if count else f"is {motion!r}"
        raise TypeError(
            f"inputs[{name!r}] {told}: give its motion as a list, as in [position, velocity], whose entries may be arrays"
        )


def _chosen(what: str, assembly: npt.ArrayLike) -> None:
    """Refuses what is neither OPEN nor CROSSED."""
    try:
        signs = np.asarray(assembly, dtype=np.float64)
    except (TypeError, ValueError):
        signs = np.array(np.nan)
    if not np.all((signs == OPEN) | (signs == CROSSED)):
        raise TypeError(f"{what} is {assembly!r}: give OPEN or CROSSED, or an array of them")
