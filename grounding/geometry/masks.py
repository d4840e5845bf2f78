"""Sets of objects as integers: bit i is the i-th object of a layout. Equality and union cost next to nothing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator


def mask_of(indices: Iterable[int]) -> int:
    """The set of the given indices."""
    mask = 0
    for index in indices:
        mask |= 1 << int(index)
    return mask


def indices_of(mask: int) -> Iterator[int]:
    """The indices in a set, ascending."""
    while mask:
        low = mask & -mask
        yield low.bit_length() - 1
        mask ^= low


def single(mask: int) -> bool:
    """Whether a set has exactly one member."""
    return mask != 0 and mask & (mask - 1) == 0
