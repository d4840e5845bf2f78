"""Parameters are varied within their ranges, and what does not change them changes nothing."""

import pytest
from held_out import FROZEN
from instructions import read_instructions
from sensitivity import answers, right, values

from grounding import Grounder
from grounding.lexicon.parameters import Parameter, parameters, varied


@pytest.mark.parametrize("name", sorted(parameters()))
def test_varied_values_stay_in_range(name):
    parameter = parameters()[name]
    low, high = values(parameter, 0.25)
    assert parameter.low <= low <= parameter.value <= high <= parameter.high
    assert low < high


def test_what_is_zero_varies_by_its_range():
    assert values(Parameter("a.b", 0.0, "1", -1.0, 1.0, "nothing"), 0.25) == (-0.5, 0.5)


def test_the_same_values_give_the_same_answers():
    instructions, worlds = read_instructions(FROZEN, FROZEN.with_suffix(".worlds.json"))
    instructions = instructions[:4]
    grounder = Grounder.load()
    before = answers(grounder, instructions, worlds)
    with varied(direction__ahead=parameters()["direction.ahead"].value):
        again = answers(grounder, instructions, worlds)
    assert [a.actions for a in before] == [a.actions for a in again]
    assert 0 <= right(before, instructions) <= 1
