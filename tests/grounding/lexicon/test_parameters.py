"""Parameters: each lies in its range and says what it is; other files are refused where they are wrong."""

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import grounding
import models
from grounding import Grounder, load_world
from grounding.errors import LexiconError
from grounding.lexicon.parameters import PARAMETERS, parameters, read_parameters, value, varied

SHIPPED = PARAMETERS.read_text(encoding="utf-8")
AHEAD = 'ahead = { value = 0.4, unit = "edges", range = [0.0, 1.0],'


def refused(tmp_path, text):
    path = tmp_path / "numbers.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(LexiconError, match=re.escape(str(path))) as error:
        read_parameters(path)
    return str(error.value)


def test_a_copy_of_the_shipped_file_says_the_same(tmp_path):
    path = tmp_path / "numbers.toml"
    path.write_text(SHIPPED, encoding="utf-8")
    assert read_parameters(path) == parameters()


def test_every_parameter_is_in_its_range_and_explained():
    for parameter in parameters().values():
        assert parameter.low <= parameter.value <= parameter.high
        assert parameter.low < parameter.high
        assert parameter.says
        assert parameter.unit
        assert value(parameter.name) == parameter.value


def test_every_parameter_takes_part():
    source = "".join(path.read_text(encoding="utf-8") for path in Path(grounding.__file__).parent.rglob("*.py"))
    composed = {f"direction.{kind}{name}" for kind in ("", "strict_") for name in ("spread", "width")}
    composed |= {"arrangement.askew", "arrangement.pair"}
    assert {name for name in parameters() if f'"{name}"' not in source} == composed


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (AHEAD, AHEAD.replace("0.4", "1.4"), "direction.ahead = 1.4 is out of range; it lies between 0.0 and 1.0"),
        (AHEAD, AHEAD.replace("0.4", '"far"'), "direction.ahead: expected a number and found 'far'"),
        (AHEAD, AHEAD.replace("0.4", "true"), "direction.ahead: expected a number"),
        (AHEAD, AHEAD.replace(' unit = "edges",', ""), "direction.ahead: expected {value, unit, range, says}"),
        (AHEAD, AHEAD.replace("[0.0, 1.0]", "[0.0]"), "direction.ahead: expected a range of two numbers"),
        ("ahead = {", "ahed = {", "is"),
        ("[direction]", "direction = 3\n[direct]", "to be a section"),
        ("[direction]", "[direction", "no TOML"),
    ],
)
def test_what_is_wrong_is_refused(tmp_path, old, new, says):
    assert says in refused(tmp_path, SHIPPED.replace(old, new, 1))


def test_missing_and_unknown_parameters_are_named(tmp_path):
    lines = SHIPPED.splitlines()
    without = [line for line in lines if not line.startswith("decay = ")]
    assert "direction.decay is missing" in refused(tmp_path, "\n".join(without))
    more = SHIPPED.replace("[nearness]", f"[nearness]\n{AHEAD.replace('ahead', 'close')} says = \"x\" }}")
    assert "nearness.close is no parameter" in refused(tmp_path, more)


@given(st.sampled_from(sorted(parameters())), st.floats(0, 1))
def test_values_vary_within_a_context_only(name, share):
    parameter = parameters()[name]
    other = min(parameter.low + share * (parameter.high - parameter.low), parameter.high)
    with varied(**{name.replace(".", "__"): other}):
        assert value(name) == other
    assert value(name) == parameter.value


def test_variations_are_checked():
    with pytest.raises(LexiconError, match=r"'direction\.far'.*direction\.ahead"), varied(direction__far=1.0):
        pass
    with pytest.raises(LexiconError, match=r"between 0\.0 and 1\.0"), varied(direction__ahead=7.0):
        pass
    with pytest.raises(ZeroDivisionError), varied(direction__ahead=0.5):
        raise ZeroDivisionError
    assert value("direction.ahead") == parameters()["direction.ahead"].value


def test_a_grounder_heeds_other_values_also_where_it_has_met_the_text_before():
    grounder = Grounder.load()
    world = load_world(models.SCENES / "default.json")
    text = "pick up the block behind the leftmost block"
    before = grounder.ground(text, world).actions + grounder.ground(text, world).alternatives
    with varied(direction__width=1.5, direction__spread=1.5):
        other = grounder.ground(text, world)
    again = grounder.ground(text, world)
    assert [a.probability for a in before] != [a.probability for a in other.actions + other.alternatives]
    assert [a.probability for a in before] == [a.probability for a in again.actions + again.alternatives]
