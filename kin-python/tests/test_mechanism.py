"""Declarations, dimensions, and what mistakes in them say."""

import copy
import pickle

import pytest

import kin

CRANK = """
    struct SliderCrank { r: Length, l: Length }
    input theta: Angle;
    unknown phi: Angle, s: Length;
    r * cis(theta) + l * cis(phi) == vec2(s, 0);
    output pin: Point = r * cis(theta);
"""


def test_a_mechanism_tells_its_names():
    mechanism = kin.Mechanism(CRANK)
    assert mechanism.name == "SliderCrank"
    assert mechanism.dimensions == ("r", "l")
    assert mechanism.inputs == ("theta",)
    assert mechanism.unknowns == ("phi", "s")
    assert mechanism.outputs == ("pin",)
    assert mechanism.assemblies == ("open", "crossed")
    assert mechanism.order == 4
    assert mechanism.text == CRANK
    assert repr(mechanism) == "<kin.Mechanism SliderCrank(r, l): theta -> phi, s>"


def test_every_mistake_is_shown_with_its_line():
    text = "struct A { r: Length }\ninput θ: Angel;\nunknown x: Length;\nx == r * cos(q);"
    with pytest.raises(kin.DeclarationError) as caught:
        kin.Mechanism(text)
    error = caught.value
    assert [(mistake.line, mistake.column, mistake.end_column) for mistake in error.mistakes] == [
        (2, 10, 15),
        (4, 14, 15),
    ]
    assert "2 | input θ: Angel;\n  |          ^^^^^" in str(error)
    assert "4 | x == r * cos(q);\n  |              ^" in str(error)
    first = error.mistakes[0]
    assert first.fault == "`Angel` is not a dimension" and first.advice.endswith("did you mean `Angle`?")
    assert first.message == f"{first.fault}: {first.advice}"
    assert error.text == text
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.mistakes) == (str(error), error.mistakes)


@pytest.mark.parametrize("text", ["", "{", "\0", "🦀", "struct", "x == 1;" * 1000, "(" * 5000])
def test_garbage_is_a_declaration_error(text):
    with pytest.raises(kin.DeclarationError):
        kin.Mechanism(text)


def test_a_declaration_that_is_too_large_is_refused():
    with pytest.raises(kin.DeclarationError) as caught:
        kin.Mechanism(" " * 10_000_000)
    assert caught.value.mistakes == []


@pytest.mark.parametrize(
    "dimensions, message",
    [
        ({"r": 1}, "missing: dimension `l`"),
        ({"r": 1, "l": 3, "k": 4}, "no dimension is called `k`: dimensions are r, l"),
        ({"r": "1", "l": 3}, "`r`: must be real number, not str"),
        ({"r": 1 + 0j, "l": 3}, "`r`: must be real number, not complex"),
        ({"r": None, "l": 3}, "`r`: must be real number, not NoneType"),
    ],
)
def test_dimensions_are_given_by_name(dimensions, message):
    with pytest.raises(TypeError) as caught:
        kin.Mechanism(CRANK)(**dimensions)
    assert str(caught.value) == message


def test_points_are_dimensions():
    mechanism = kin.Mechanism(
        """
        struct Crank { pivot: Point, r: Length }
        input theta: Angle;
        unknown x: Length;
        x == pivot.x + r * cos(theta);
        output tip: Point = pivot + r * cis(theta);
        """
    )
    assert mechanism.dimensions == ("pivot", "r")
    linkage = mechanism(pivot=(3.0, 4.0), r=1.0)
    assert linkage.dimensions == {"pivot": (3.0, 4.0), "r": 1.0}
    assert mechanism(**{"pivot.x": 3, "pivot.y": 4, "r": 1}) == linkage
    assert linkage.solve(theta=0.0).tip.position.tolist() == [4.0, 4.0]
    for wrong in (3.0, (1, 2, 3), ()):
        with pytest.raises(TypeError, match=r"`pivot` is a point: give its 2 coordinates, as in `pivot=\(x, y\)`"):
            mechanism(pivot=wrong, r=1.0)
    with pytest.raises(TypeError, match="missing: dimension `pivot`"):
        mechanism(**{"pivot.x": 3}, r=1)
    with pytest.raises(TypeError, match="given twice"):
        mechanism(**{"pivot.x": 3}, pivot=(1, 2), r=1)


def test_equal_linkages():
    one, other = (kin.Mechanism(CRANK)(r=1, l=length) for length in (3.0, 3))
    assert one == other and hash(one) == hash(other)
    assert one != kin.Mechanism(CRANK)(r=1, l=2) and one != "SliderCrank"
    assert repr(one) == "SliderCrank(r=1.0, l=3.0)"


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))])
def test_copies(again):
    linkage = kin.Mechanism(CRANK)(r=1, l=3)
    pose = linkage.solve(theta=[0.5, 1.0], assembly="open")
    assert again(linkage.mechanism).text == CRANK
    assert again(linkage) == linkage
    assert again(pose).s.snap == pose.s.snap
    assert again(pose).pin.jerk.tolist() == pose.pin.jerk.tolist()


def test_the_library_has_every_mechanism():
    assert len(kin.library.names()) == 37
    assert set(kin.library.names()) < set(dir(kin.library))
    assert kin.library.four_bar is kin.library.mechanism("four_bar")
    with pytest.raises(AttributeError, match="no mechanism of the library is called `for_bar`"):
        kin.library.for_bar


def test_what_quantities_measure():
    mechanism = kin.Mechanism(CRANK)
    measures = [mechanism.measure_of(name) for name in ("theta", "phi", "s", "pin.x")]
    assert measures == ["angle", "angle", "length", "length"]
    for wrong in ("pin", "s_jerk", "r"):
        with pytest.raises(KeyError, match=f"no quantity is called `{wrong}`"):
            mechanism.measure_of(wrong)
