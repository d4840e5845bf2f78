"""`python -m grounding features`: explains and counts the binary features of trained weights."""

from __future__ import annotations

import argparse
import json
import re
import sys
import textwrap
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

import models
from grounding.commands import SUMMARIES
from grounding.errors import ModelError
from grounding.factors import Factor, load_model
from grounding.features.explained import CONCRETE, FACTS, ROLES, explain_fact, explain_role
from grounding.features.forms import Form

PAPER = 50_820  # binary features of the paper's model, Section V
_DEFAULT_LIMIT = 20
_WIDTH = 110


@dataclass
class Group:
    """Facts or roles of one form.

    Attributes:
        form: of the register; None where none fits.
        names: the facts or roles of this form, each with how many features it is part of.
        strongest: the largest absolute weight that each is part of.
        families: in whose factors they occur.
    """

    form: Form | None
    names: dict[str, int] = field(default_factory=dict)
    strongest: dict[str, float] = field(default_factory=dict)
    families: list[str] = field(default_factory=list)

    @property
    def example(self) -> str:
        """The name that weighs most."""
        return max(self.names, key=lambda name: (self.strongest[name], name))


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `features`."""
    parser = subparsers.add_parser(
        "features", help=SUMMARIES["features"],
        description="Explains and counts the binary features of trained weights. A feature is a pair of a fact of the "
        "context and a role of the symbol; what facts and roles mean is listed by their forms.",
    )  # fmt: skip
    parser.add_argument("--weights", type=Path, default=models.WEIGHTS, metavar="FILE",
                        help="weights.npz of a training (default: those that ship with the project)")  # fmt: skip
    parser.add_argument("--family", metavar="NAME", help="only the factor of this family")
    parser.add_argument("--find", type=_text, metavar="TEXT",
                        help="list the features with this in fact or role, the strongest weights first")  # fmt: skip
    parser.add_argument("--limit", type=_count, default=_DEFAULT_LIMIT, metavar="N",
                        help=f"of --find, show so many (default: {_DEFAULT_LIMIT})")  # fmt: skip
    parser.add_argument("--json", action="store_true", help="print everything as JSON")
    parser.add_argument("--markdown", action="store_true",
                        help="print the tables of docs/features.md: counts, and all forms")  # fmt: skip


def run(args: argparse.Namespace) -> int:
    """Explain the whole, or list what was asked for."""
    path = args.weights / models.WEIGHTS.name if args.weights.is_dir() else args.weights
    factors = dict(load_model(path).factors)
    if args.family is not None:
        if args.family not in factors:
            raise ModelError(f"{path}: no family {args.family!r} in these weights; they have {', '.join(factors)}")
        factors = {args.family: factors[args.family]}
    if args.find is not None:
        return _find(factors, args.find, args.limit, args.json)
    facts, roles = group_facts(factors), group_roles(factors)
    if args.markdown:
        print("\n".join([*markdown_counts(factors), "", *markdown_tables()]))
    elif args.json:
        print(json.dumps(_plain(factors, facts, roles), indent=1))
    else:
        print("\n".join(_described(factors, facts, roles)))
    return 0


def markdown_counts(factors: Mapping[str, Factor]) -> list[str]:
    """What is counted, as a table by family."""
    lines = ["| family | facts | roles | pairs | features |", "| --- | ---: | ---: | ---: | ---: |"]
    pairs = features = 0
    for family, factor in factors.items():
        lines.append(f"| {family} | {len(factor.facts):,} | {len(factor.roles):,} | {factor.weights.size:,} "
                     f"| {factor.feature_count:,} |")  # fmt: skip
        pairs, features = pairs + factor.weights.size, features + factor.feature_count
    return [*lines, f"| all | | | {pairs:,} | {features:,} |"]


def markdown_tables() -> list[str]:
    """All forms as two tables, of facts and of roles."""

    def code(name: str) -> str:
        return f"`{name}`".replace("|", "\\|")

    def prose(meaning: str) -> str:
        return re.sub(r"<(\w+)>", r"*\1*", meaning)

    lines = ["| fact | means | for example |", "| --- | --- | --- |"]
    lines += [f"| {code(form.template)} | {prose(form.meaning)} | {code(form.example)} |" for form in FACTS]
    lines += ["", "| role | of | means | for example |", "| --- | --- | --- | --- |"]
    for form in ROLES:
        families = "concrete symbols" if form.families == CONCRETE else ", ".join(form.families) or "all"
        lines.append(f"| {code(form.template)} | {families} | {prose(form.meaning)} | {code(form.example)} |")
    return lines


def group_facts(factors: Mapping[str, Factor]) -> list[Group]:
    """The facts of some factors by form, in the order of the register; unexplained ones last."""
    groups: dict[Form | None, Group] = {form: Group(form) for form in (*FACTS, None)}
    for family, factor in factors.items():
        _enter(groups, family, factor.facts, np.asarray(factor.weights), False)
    return [group for group in groups.values() if group.names]


def group_roles(factors: Mapping[str, Factor]) -> list[Group]:
    """The roles of some factors by form, likewise."""
    groups: dict[Form | None, Group] = {form: Group(form) for form in (*ROLES, None)}
    for family, factor in factors.items():
        _enter(groups, family, factor.roles, np.asarray(factor.weights).T, True)
    return [group for group in groups.values() if group.names]


def _enter(groups: dict[Form | None, Group], family: str, names: Iterable[str], rows: np.ndarray, roles: bool) -> None:
    counts = np.count_nonzero(rows, axis=1).tolist()
    strongest = np.abs(rows).max(axis=1, initial=0.0).tolist()
    for name, count, weight in zip(names, counts, strongest, strict=True):
        found = explain_role(name, family) if roles else explain_fact(name, family)
        group = groups[found and found.form]
        group.names[name] = group.names.get(name, 0) + count
        group.strongest[name] = max(group.strongest.get(name, 0.0), weight)
        if family not in group.families:
            group.families.append(family)


def _described(factors: Mapping[str, Factor], facts: list[Group], roles: list[Group]) -> list[str]:
    total = sum(factor.feature_count for factor in factors.values())
    pairs = sum(factor.weights.size for factor in factors.values())
    lines = [f"{total:,} binary features with a weight, of {pairs:,} pairs of a fact and a role "
             f"(the paper's model has {PAPER:,})", "",
             f"{'family':<12} {'facts':>7} {'roles':>7} {'pairs':>9} {'features':>9}"]  # fmt: skip
    for family, factor in factors.items():
        lines.append(f"{family:<12} {len(factor.facts):>7,} {len(factor.roles):>7,} {factor.weights.size:>9,} "
                     f"{factor.feature_count:>9,}")  # fmt: skip
    for title, groups in (("Facts of the context", facts), ("Roles of the symbol", roles)):
        names = {name for group in groups for name in group.names}
        lines += ["", f"{title}: {len(names):,} in {sum(group.form is not None for group in groups)} forms"]
        for group in groups:
            of = f" [{', '.join(group.families)}]" if groups is roles and len(factors) > 1 else ""
            size = f"x {len(group.names):,}, in {sum(group.names.values()):,} features{of}"
            if group.form is None:
                lines += [f"  unexplained  {size}:", *(f"      {name}" for name in sorted(group.names))]
                continue
            told = group.form.meaning + (f"; e.g. {group.example}" if group.example != group.form.template else "")
            lines.append(f"  {group.form.template}  {size}")
            lines += textwrap.wrap(told, _WIDTH, initial_indent=" " * 6, subsequent_indent=" " * 6)
    return lines


def _plain(factors: Mapping[str, Factor], facts: list[Group], roles: list[Group]) -> dict[str, Any]:
    def listed(groups: list[Group]) -> list[dict[str, Any]]:
        return [
            {"form": group.form.template, "means": group.form.meaning, "example": group.example,
             "count": len(group.names), "features": sum(group.names.values()), "families": group.families}
            for group in groups if group.form is not None
        ]  # fmt: skip

    def unexplained(groups: list[Group]) -> list[str]:
        return sorted(name for group in groups if group.form is None for name in group.names)

    return {
        "features": sum(factor.feature_count for factor in factors.values()),
        "pairs": sum(factor.weights.size for factor in factors.values()),
        "paper": PAPER,
        "families": [
            {"family": family, "facts": len(factor.facts), "roles": len(factor.roles), "pairs": factor.weights.size,
             "features": factor.feature_count}
            for family, factor in factors.items()
        ],
        "facts": listed(facts),
        "roles": listed(roles),
        "unexplained": {"facts": unexplained(facts), "roles": unexplained(roles)},
    }  # fmt: skip


def _find(factors: Mapping[str, Factor], text: str, limit: int, as_json: bool) -> int:
    wanted = text.casefold()
    found: list[tuple[float, str, str, str]] = []
    for family, factor in factors.items():
        rows = np.array([wanted in name.casefold() for name in factor.facts], dtype=bool)
        columns = np.array([wanted in name.casefold() for name in factor.roles], dtype=bool)
        for row, column in zip(*np.nonzero((rows[:, None] | columns[None]) & (factor.weights != 0)), strict=True):
            found.append((float(factor.weights[row, column]), family, factor.facts[row], factor.roles[column]))
    found.sort(key=lambda entry: (-abs(entry[0]), entry[1:]))
    shown = found[:limit]
    if as_json:
        print(json.dumps({"find": text, "matching": len(found), "features": [_feature(*entry) for entry in shown]},
                         indent=1))  # fmt: skip
        return 0
    for weight, family, fact, role in shown:
        explained = _feature(weight, family, fact, role)
        print(f"{weight:+8.3f}  {family}: {fact}  x  {role}")
        told = f"{explained['fact_means'] or 'unexplained'}  x  {explained['role_means'] or 'unexplained'}"
        print("\n".join(textwrap.wrap(told, _WIDTH, initial_indent=" " * 10, subsequent_indent=" " * 10)))
    print(f"{len(found):,} features match {text!r}" + (f"; {len(shown)} shown" if len(shown) < len(found) else ""),
          file=sys.stderr)  # fmt: skip
    return 0


def _feature(weight: float, family: str, fact: str, role: str) -> dict[str, Any]:
    of_fact, of_role = explain_fact(fact, family), explain_role(role, family)
    return {"weight": round(weight, 5), "family": family, "fact": fact, "role": role,
            "fact_means": of_fact and of_fact.meaning, "role_means": of_role and of_role.meaning}  # fmt: skip


def _text(text: str) -> str:
    if not text.strip():
        raise argparse.ArgumentTypeError("expected some text to look for, e.g. middle")
    return text


def _count(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        value = 0
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is no whole number from 1")
    return value
