"""Cells of a grid that a moving body touches."""

import numpy
import pytest

import taut2d


def cart(motion):
    return taut2d.Scene(time=(0, 1), bodies=[taut2d.Body("cart", [(0, 0), (1, 0), (1, 1), (0, 1)], motion)])


def test_by_hand():
    found = taut2d.cells(cart(taut2d.Velocity((0.5, 0))), "cart", 2, origin=(-0.5, -0.5))
    assert found.cells == ((0, 0), (1, 0))
    assert (found.body, found.resolution, found.origin, len(found)) == ("cart", 2.0, (-0.5, -0.5), 2)
    mask, first = found.mask()
    assert mask.tolist() == [[True, True]] and first == (0, 0)


def test_a_turn_against_samples():
    found = taut2d.cells(cart(taut2d.Sweep(0, 360)), "cart", 0.125)
    mask, (column, row) = found.mask()
    assert mask.sum() == len(found)
    # The square sweeps a disc whose radius is its diagonal.
    for i, j in found.cells:
        away = numpy.hypot(max(i, 0, -i - 1), max(j, 0, -j - 1)) * 0.125
        assert away <= numpy.sqrt(2) + 0.125 / 16
    assert not mask.all() and mask[-row, -column]


def test_faults():
    with pytest.raises(taut2d.InputError, match="there is no body"):
        taut2d.cells(cart(None), "car", 1)
    with pytest.raises(taut2d.InputError, match="not a positive number"):
        taut2d.cells(cart(None), "cart", 0)
