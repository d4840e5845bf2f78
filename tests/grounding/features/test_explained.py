"""Every fact and every role is explained by a form; who adds some learns here which lines are missing."""

import itertools

import pytest

import models
from grounding.corpus.loading import load_corpus
from grounding.factors import load_model
from grounding.features import FAMILIES
from grounding.features.explained import FACTS, FITS, GOALS, HOWS, ROLES, SETS, TARGETS, explain_fact, explain_role
from grounding.features.forms import Form, as_is, first_of, nested, one_of
from grounding.geometry.layout import Layout
from grounding.learning.examples import PROPOSED, Negatives, annotated, collect

NAMES = [family.name for family in FAMILIES]
TELL = (
    "not explained: {}. Add their forms to grounding/features/explained.py, then renew the tables of docs/features.md"
)


def told(missing):
    return TELL.format("; ".join(f"{family}: {name}" for family, name in sorted(missing)[:30]))


def test_every_fact_and_role_of_the_shipped_weights_is_explained():
    factors = load_model(models.WEIGHTS).factors
    missing = {(family, f"fact {name}") for family, factor in factors.items() for name in factor.facts
               if explain_fact(name, family) is None}  # fmt: skip
    missing |= {(family, f"role {name}") for family, factor in factors.items() for name in factor.roles
                if explain_role(name, family) is None}  # fmt: skip
    assert not missing, told(missing)


@pytest.mark.parametrize("negatives", [PROPOSED, Negatives(4, 8)], ids=["proposed", "all of Γ"])
def test_every_fact_and_role_that_the_program_makes_now_is_explained(negatives):
    """Of a sample of the treebank: weights may be older than the features."""
    corpus = load_corpus(None)
    layouts = {name: Layout(world) for name, world in corpus.worlds.items()}
    sample = list(corpus.examples)[::100]
    sets, _ = collect((annotated(e.tree, e.groundings, layouts[e.world]) for e in sample), negatives)
    missing = set()
    checked = 0
    for family, data in sets.items():
        missing |= {(family, f"fact {name}") for name in data.facts if explain_fact(name, family) is None}
        missing |= {(family, f"role {name}") for name in data.roles if explain_role(name, family) is None}
        checked += len(data.facts) + len(data.roles)
    assert checked > 800
    assert not missing, told(missing)


@pytest.mark.parametrize("form", FACTS, ids=lambda form: form.template)
def test_facts_have_the_form_that_their_example_is_of(form):
    found = explain_fact(form.example)
    assert found is not None
    assert found.form is form
    assert "<" not in found.meaning


@pytest.mark.parametrize("form", ROLES, ids=lambda form: f"{form.template} of {'+'.join(form.families)}")
def test_roles_have_the_form_that_their_example_is_of(form):
    for family in form.families:
        found = explain_role(form.example, family)
        assert found is not None
        assert "<" not in found.meaning
        assert found.form is form, found.form.template


def test_families_of_forms_are_those_of_the_factors():
    assert {family for form in (*FACTS, *ROLES) for family in form.families} <= set(NAMES)
    assert set(NAMES) == {family for form in ROLES for family in form.families}


@pytest.mark.parametrize(
    "name",
    ["", "wug", "word=", "nth[mod.in|head|sixth]", "have wug", "row deviation", "is spatial", "mod.relation=wug",
     "composed wug(A)", "composed head(X)", "shape=NP:wug", "member wug", "circle deviation x",
     "all own|own|own", "12 seen"],
)  # fmt: skip
def test_what_has_no_form_stays_unexplained(name):
    assert explain_fact(name) is None
    assert all(explain_role(name, family) is None for family in NAMES)


def test_roles_are_explained_in_their_own_family():
    assert "grounded to it too" in explain_role("in mod", "spatial").meaning
    assert "it is among" in explain_role("in mod", "object").meaning
    assert explain_role("named", "action") is None


def test_blanks_are_filled_with_words():
    assert explain_role("nth[mod.in|head|first]", "object").meaning == (
        "it is among: of what the modifier is grounded to, the one at the first rank along the direction that the head "
        "phrase says"
    )
    assert explain_fact("composed head(iA)+mod(C) by in").meaning == (
        'the head phrase speaks of a rank and an object attribute; the modifier speaks of a container; joined by "in"'
    )
    assert explain_fact("word=$").meaning == 'the word "$" is among the phrase\'s own words'


def test_forms_take_special_characters_as_they_are():
    form = Form("a.b[<x>|<x2>]", "<x2> after <x>", "a.b[p|qq]", (), {"x": one_of({"p": "one", "qq": "two"})})
    assert form.explain("a.b[p|qq]") == "two after one"
    assert form.explain("a-b[p|qq]") is None
    assert form.explain("a.b[p|q]") is None
    outer = Form("have <y>", "it has <y>", "have a.b[p|p]", (), {"y": nested([form])})
    assert outer.explain("have a.b[p|p]") == "it has one after one"
    assert outer.explain("have c") is None
    word = Form("w=<w>", "<w>", "w=1", ("here",), {"w": as_is(r"\d")})
    assert first_of([word], "w=7", "there") is None
    assert first_of([word], "w=7", "here").meaning == '"7"'


def test_no_two_forms_of_a_family_are_the_same():
    for forms in (FACTS, SETS, FITS, HOWS, TARGETS, GOALS):
        templates = [form.template for form in forms]
        assert len(set(templates)) == len(templates)
    for family in NAMES:
        of_family = [form.template for form in ROLES if family in form.families]
        double = {a for a, b in itertools.pairwise(sorted(of_family)) if a == b}
        assert not double
