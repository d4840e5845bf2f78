"""Literal readings: what a text means where its words are taken at their sharpest.

A graded reading always points somewhere. A literal one presupposes: "the" asks for one thing, "the third" for three,
"behind the tower" for something in the region that Γ calls so. It names what is meant, leaves open what holds of
several, or tells what is not there; and it is silent where a word or a construction is beyond it, or where what is
asked for is too close to call.
"""

from grounding.literal.belief import SILENT, LiteralBelief, believe_literally
from grounding.literal.texts import Literal, read_literally

__all__ = ["SILENT", "Literal", "LiteralBelief", "believe_literally", "read_literally"]
