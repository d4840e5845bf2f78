"""Print what an instruction means in a scene, phrase by phrase, without robot or simulator.

python examples/ground_only.py [INSTRUCTION [SCENE]]
"""

import sys

import models
from grounding import Grounder, load_world

text = sys.argv[1] if len(sys.argv) > 1 else "take the rightmost red block"
scene = sys.argv[2] if len(sys.argv) > 2 else "twelve"
result = Grounder.load().ground(text, load_world(models.SCENES / f"{scene}.json"))

print(result.outcome, *(f"{a.action} {' '.join(a.objects)} ({a.probability:.2f})" for a in result.actions))
print(result.question or result.explanation)
for phrase in result.phrases:
    meant = ", ".join(f"{symbol} {probability:.2f}" for symbol, probability in phrase.groundings)
    print(f"{'  ' * phrase.depth}{phrase.text}: {meant or 'nothing'}")
