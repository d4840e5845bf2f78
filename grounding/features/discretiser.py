"""From measures of shapes to binary roles: kernels map a measure to [0, 1], uniform sampling makes bins of that.

`row fit se 3` is the role of a row whose deviation, through the squared-exponential kernel, lies in the fourth of the
evenly spaced bins (Section IV-C). Measures are taken once for a set, a kind and a world, many sets at a time.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple
from weakref import WeakKeyDictionary

import numpy as np

from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of
from grounding.geometry.shapes import MEASURES, Subsets, between_all, measure
from grounding.space import ARRANGEMENT_KINDS
from grounding.world import Array

LOOKS = ("unlike its looks", "as it looks")  # whether people would see the kind in a set, a line or else a group
STRAIGHT, EVEN, APART, ALONG = 0.45, 0.58, 0.58, 0.5  # bounds on fit, coherence, separation and orientation of a line
MOST_COUNTED = 4  # larger sets are alike in size
_BATCH = 4096  # sets measured at a time: bounds the memory


class Kernel(NamedTuple):
    """A map from a measure to [0, 1] and its bins.

    Attributes:
        measure: one of `MEASURES`.
        name: "linear", x over the scale and at most 1, or "se", exp(-(x / scale)^2 / 2).
        scale: of the measure.
        steps: bins a unit; what reaches 1 has a bin of its own.
    """

    measure: str
    name: str
    scale: float
    steps: int

    def bins(self, values: Array) -> np.ndarray:
        """The bin of each value, 0 to `steps`."""
        mapped = (
            np.minimum(values / self.scale, 1.0) if self.name == "linear" else np.exp(-((values / self.scale) ** 2) / 2)
        )
        return np.floor(mapped * self.steps + 1e-6).astype(np.int64)  # what reaches a bound but for rounding is there


KERNELS = (
    Kernel("likelihood", "linear", 1.0, 4),
    Kernel("fit", "linear", 1.0, 4),
    Kernel("fit", "se", 0.15, 5),
    Kernel("coherence", "linear", 1.0, 5),
    Kernel("separation", "linear", 3.0, 5),
    Kernel("separation", "se", 0.75, 4),
    Kernel("ordering", "linear", 1.0, 4),
    Kernel("orientation", "linear", 1.0, 5),
    Kernel("distinction", "linear", 2.0, 4),
    Kernel("distinction", "se", 0.5, 4),
)


_SEEN = ("row", "column", "group")


def role_names(kind: str) -> tuple[tuple[str, ...], ...]:
    """The roles of a kind, kernel by kernel, and last those of the number of members."""
    bins = [tuple(f"{kind} {k.measure} {k.name} {i}" for i in range(k.steps + 1)) for k in KERNELS]
    counts = tuple(f"{kind} of {count}" for count in range(MOST_COUNTED + 1))
    looks = (LOOKS, tuple(f"{kind} {look}" for look in LOOKS)) if kind in _SEEN else ()
    return (*bins, counts, *looks)


class ShapeRoles:
    """The roles of sets of one world's things, measured when asked for and remembered."""

    def __init__(self, layout: Layout) -> None:
        self._positions = layout.positions
        self._edge = layout.edge
        self._distances = between_all(layout.positions)
        self._known: dict[tuple[str, int], tuple[str, ...]] = {}
        self._lines: dict[int, str] = {}
        self._every: dict[str, np.ndarray] = {}

    def of(self, keys: Iterable[tuple[str, int]]) -> list[tuple[str, ...]]:
        """The roles of sets as shapes.

        Args:
            keys: kinds and masks.
        """
        asked = list(keys)
        missing: dict[str, dict[int, None]] = {}
        for kind, mask in asked:
            if (kind, mask) not in self._known:
                missing.setdefault(kind, {})[mask] = None
        for kind, masks in missing.items():
            names = role_names(kind)
            for mask, codes in zip(masks, self.codes(kind, list(masks)).T.tolist(), strict=True):
                self._known[kind, mask] = tuple(of[code] for of, code in zip(names, codes, strict=True))
        return [self._known[key] for key in asked]

    def line_kind(self, mask: int) -> str:
        """Whether a set is rather a row or a column, by its principal axis."""
        if mask not in self._lines:
            points = self._positions[list(indices_of(mask)), :2]
            x, y = (points - points.mean(axis=0)).T
            self._lines[mask] = "row" if float(y @ y) >= float(x @ x) else "column"
        return self._lines[mask]

    def codes(self, kind: str, masks: Sequence[int]) -> np.ndarray:
        """Which of `role_names` each set has, shape (len(role_names), len(masks))."""
        found = []
        for start in range(0, len(masks), _BATCH):
            members = np.zeros((len(masks[start : start + _BATCH]), len(self._positions)), dtype=bool)
            for row, mask in enumerate(masks[start : start + _BATCH]):
                members[row, list(indices_of(int(mask)))] = True
            found.append(_codes(kind, self._subsets(members)))
        return np.concatenate(found, axis=1)

    def every(self, kind: str, masks: np.ndarray) -> np.ndarray:
        """As `codes`, of a whole enumeration of masks, always the same; remembered."""
        if not self._every:
            bits = masks[:, None] >> np.arange(len(self._positions)) & 1 == 1
            batches = [self._subsets(bits[i : i + _BATCH]) for i in range(0, len(masks), _BATCH)]
            for one in ARRANGEMENT_KINDS:
                self._every[one] = np.concatenate([_codes(one, batch) for batch in batches], axis=1)
        return self._every[kind]

    def _subsets(self, members: np.ndarray) -> Subsets:
        return Subsets(self._positions, self._edge, members, self._distances)


def _codes(kind: str, subsets: Subsets) -> np.ndarray:
    values = measure(kind, subsets)
    columns = [kernel.bins(values[:, MEASURES.index(kernel.measure)]) for kernel in KERNELS]
    columns.append(np.minimum(subsets.count, MOST_COUNTED).astype(np.int64))
    if kind in _SEEN:
        lined = _straight(measure("row", subsets) if kind == "group" else values)
        right = ~lined if kind == "group" else lined & (values[:, _ORIENTATION] <= ALONG)
        columns += [right.astype(np.int64)] * 2
    return np.stack(columns)


_MEASURED = frozenset(
    role for kind in ARRANGEMENT_KINDS for slot in role_names(kind)[: len(KERNELS)] for role in slot
)


_GENERAL = ("region made", "carried upward", "kind said", "other kind said", "count said", "other count said")


def strictness(role: str) -> float:
    """How much more than others the weights of a role are held near zero in training.

    Bins of measures are many and each is seen in few worlds: left free, they learn those worlds by heart. What holds
    of sets of all kinds is tried first.
    """
    if role in _MEASURED:
        return 10.0
    return 0.1 if role.endswith(LOOKS) or role.startswith(_GENERAL) else 1.0


_FIT, _COHERENCE, _SEPARATION, _ORIENTATION = map(MEASURES.index, ("fit", "coherence", "separation", "orientation"))


def _straight(line: Array) -> np.ndarray:
    """Which sets are seen as lines, by their measures as one: straight, even, and with nothing else much nearer."""
    return (line[:, _FIT] < STRAIGHT) & (line[:, _COHERENCE] > EVEN) & (line[:, _SEPARATION] > APART)


_OF_LAYOUT: WeakKeyDictionary[Layout, ShapeRoles] = WeakKeyDictionary()


def shape_roles(layout: Layout) -> ShapeRoles:
    """The roles of a world's shapes; those of its arrangements are measured together, the first time."""
    known = _OF_LAYOUT.get(layout)
    if known is None:
        known = _OF_LAYOUT[layout] = ShapeRoles(layout)
        known.of(layout.by_members)
    return known
