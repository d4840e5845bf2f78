"""Data that ships with the project: scenes, treebank, texts, grammar and weights, the robot's recipe. No behaviour."""

from pathlib import Path

ROOT = Path(__file__).resolve().parent
SCENES = ROOT / "scenes"
BAXTER_RECIPE = ROOT / "baxter" / "recipe.json"
GRAMMAR = ROOT / "grammar.json"
WEIGHTS = ROOT / "weights"  # .npz and .json
BELIEFS = ROOT / "beliefs.json"
TREEBANK = ROOT / "treebank"
HANDS = ROOT / "hands"
