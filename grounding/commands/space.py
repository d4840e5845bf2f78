"""`python -m grounding space`: the size of every kind of symbol in Γ, by formula and by enumeration."""

from __future__ import annotations

import argparse
import json
import math
import sys
from pathlib import Path
from typing import Any

from grounding.commands import SUMMARIES
from grounding.language.lexicon import known_words, meanings
from grounding.space import COUNTED, FIXED, KINDS, SHORTHANDS, Counts, SymbolSpace, largest_number, total
from grounding.symbols import ObjectColor, ObjectType
from grounding.world import load_world

MOST_ENUMERATED = 10  # objects: beyond, kinds that grow as 3^N take minutes
MOST_OBJECTS = 1_000_000
_GROUPED = 10**18  # from here on numbers are shown by their magnitude
_EXACT = 4000  # digits: JSON readers refuse longer integers
_RESERVED = "(){};,"


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `space`."""
    parser = subparsers.add_parser(
        "space", help=SUMMARIES["space"],
        description="The size of every kind of symbol in Γ: by formula, and for at most "
        f"{MOST_ENUMERATED} objects by enumeration too.",
    )  # fmt: skip
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--objects", type=_objects, metavar="N", help="for so many objects, and nothing else there")
    what.add_argument("--world", type=Path, metavar="FILE", help="for the objects, table and hands of a world file")
    parser.add_argument("--types", type=_labels, metavar="A,B", help="types (default: those that words can name)")
    parser.add_argument("--colors", type=_labels, metavar="A,B", help="colours (default: those that words can name)")
    parser.add_argument("--no-enumeration", action="store_true", help="by formula only")
    parser.add_argument("--json", action="store_true", help="print the sizes as JSON")


def run(args: argparse.Namespace) -> int:
    """Count, enumerate where that is feasible, and print."""
    types = _nameable(ObjectType) if args.types is None else args.types
    colors = _nameable(ObjectColor) if args.colors is None else args.colors
    space = None
    if args.world is not None:
        space = SymbolSpace.of_world(load_world(args.world), types, colors)
        counts = space.counts
    else:
        counts = Counts(args.objects, len(types), len(colors), numbers=largest_number(args.objects))
        if counts.objects <= MOST_ENUMERATED:
            space = SymbolSpace.of_size(args.objects, types, colors)
    enumerable = space is not None and counts.objects <= MOST_ENUMERATED and not args.no_enumeration
    enumerated = _enumerate(space) if space is not None and enumerable else {}
    print(json.dumps(_plain(counts, enumerated), indent=1) if args.json else "\n".join(_table(counts, enumerated)))
    return 0


def _enumerate(space: SymbolSpace) -> dict[str, int]:
    """The size of every kind, counted one by one."""
    found = {}
    told = False
    for done, kind in enumerate(KINDS):
        if kind.size(space.counts) > 1_000_000:
            bar = "#" * done + "." * (len(KINDS) - done)
            print(f"[{bar}] {done}/{len(KINDS)} kinds, now {kind.name}", file=sys.stderr, flush=True)
            told = True
        found[kind.name] = sum(1 for _ in kind.symbols(space))
    if told:
        print(f"[{'#' * len(KINDS)}] {len(KINDS)}/{len(KINDS)} kinds", file=sys.stderr, flush=True)
    return found


def _table(counts: Counts, enumerated: dict[str, int]) -> list[str]:
    rows = [("kind", "size", "enumerated", "formula")]
    for abstract in (False, True):
        for kind in KINDS:
            if kind.abstract == abstract:
                listed = _shown(enumerated[kind.name]) if kind.name in enumerated else "-"
                rows.append((kind.name, _shown(kind.size(counts)), listed, kind.formula))
        name = f"all {'abstract' if abstract else 'concrete'} symbols"
        rows.append((name, _shown(total(counts, abstract)), _sum(enumerated, abstract), ""))
    rows.append(("all symbols", _shown(total(counts)), _sum(enumerated), ""))
    widths = [max(len(row[column]) for row in rows) for column in range(3)]
    lines = []
    for name, size, listed, formula in rows:
        line = f"{name:<{widths[0]}}  {size:>{widths[1]}}  {listed:>{widths[2]}}  {formula}"
        lines += [line.rstrip(), ""] if name.startswith("all concrete") else [line.rstrip()]
    values = [f"{letter} = {getattr(counts, name):,} {name}" for letter, name in COUNTED.items()]
    lines += ["", ", ".join(values), ", ".join(f"{letter} = {value}" for letter, value in FIXED.items())]
    lines += [f"{letter} = {formula}: {meaning}" for letter, (formula, meaning) in SHORTHANDS.items()]
    if not enumerated and counts.objects > MOST_ENUMERATED:
        lines.append(f"not enumerated: that is done for at most {MOST_ENUMERATED} objects")
    return lines


def _plain(counts: Counts, enumerated: dict[str, int]) -> dict[str, Any]:
    def sizes(value: int) -> dict[str, Any]:
        magnitude = math.log10(value) if value else None
        exact = magnitude is None or magnitude < _EXACT
        return {"size": value if exact else None, "log10_size": magnitude}

    return {
        **counts._asdict(),
        "letters": FIXED,
        "kinds": [
            {"kind": kind.name, "example": kind.example, "abstract": kind.abstract, "formula": kind.formula,
             **sizes(kind.size(counts)), "enumerated": enumerated.get(kind.name)}
            for kind in KINDS
        ],
        "concrete": sizes(total(counts, False)),
        "abstract": sizes(total(counts, True)),
        "total": sizes(total(counts)),
    }  # fmt: skip


def _sum(enumerated: dict[str, int], abstract: bool | None = None) -> str:
    if not enumerated:
        return "-"
    return _shown(sum(enumerated[kind.name] for kind in KINDS if abstract is None or kind.abstract == abstract))


def _shown(value: int) -> str:
    """A number as people read it: grouped, or by its magnitude."""
    if value < _GROUPED:
        return f"{value:,}"
    magnitude = math.log10(value)
    mantissa, exponent = 10 ** (magnitude % 1), int(magnitude)
    return f"{mantissa:.3f}e{exponent}" if mantissa < 9.9995 else f"1.000e{exponent + 1}"


def _nameable(kind: type[ObjectType] | type[ObjectColor]) -> tuple[str, ...]:
    """The labels that words can name."""
    found = {symbol.name for word in known_words() for symbol in meanings(word) if isinstance(symbol, kind)}
    return tuple(sorted(found))


def _objects(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text[:40]!r} is no whole number") from None
    if value < 0:
        raise argparse.ArgumentTypeError(f"{text} is below 0; a world has 0 objects or more")
    if value > MOST_OBJECTS:
        raise argparse.ArgumentTypeError(f"{text} is too many; sizes are computed for at most {MOST_OBJECTS:,} objects")
    return value


def _labels(text: str) -> tuple[str, ...]:
    labels = tuple(label.strip() for label in text.split(",")) if text.strip() else ()
    for label in labels:
        if not label or label == "-" or any(c.isspace() or c in _RESERVED for c in label):
            raise argparse.ArgumentTypeError(f"{label!r} is no label; labels are single words, set apart by commas")
    if len(set(labels)) < len(labels):
        raise argparse.ArgumentTypeError(f"{text!r} names a label twice")
    return labels
