"""Weights on disk: what is written is read, in the same bytes; what is damaged is refused, and nothing is executed."""

import json
import pickle
import zipfile
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import models
from grounding.errors import ModelError
from grounding.factors import Factor, FactorModel, FirstPass, load_model, save_model


def model(seed=0):
    rng = np.random.default_rng(seed)
    factors = {}
    for name, rows, columns in (("object", 7, 5), ("verb", 3, 4), ("empty", 0, 0)):
        weights = np.round(rng.normal(size=(rows, columns)), 5)
        factors[name] = Factor(tuple(f"f{i} ä" for i in range(rows)), tuple(f"r{i}" for i in range(columns)), weights)
    return FactorModel(factors, {"penalty": 0.3, "examples": 7})


@pytest.fixture
def saved(tmp_path):
    save_model(model(), tmp_path / "weights")
    return tmp_path / "weights"


def test_what_is_written_is_read(saved):
    again = load_model(saved)
    assert again.notes == model().notes
    assert set(again.factors) == set(model().factors)
    assert again.feature_count == model().feature_count
    for name, factor in model().factors.items():
        other = again.factors[name]
        assert (other.facts, other.roles) == (factor.facts, factor.roles)
        np.testing.assert_allclose(other.weights, factor.weights, atol=1e-5)


def test_facts_and_roles_without_weight_are_left_out(tmp_path):
    weights = np.array([[1.0, 0.0], [0.0, 0.0], [2.0, 1e-7]])
    save_model(FactorModel({"a": Factor(("x", "y", "z"), ("r", "s"), weights)}, {}), tmp_path / "w")
    factor = load_model(tmp_path / "w").factors["a"]
    assert (factor.facts, factor.roles) == (("x", "z"), ("r",))
    assert factor.role_weights(["x", "y", "z"]) == {"r": 3.0}


def contents(path):
    return [path.with_suffix(ending).read_bytes() for ending in (".npz", ".json")]


def test_the_same_weights_give_the_same_bytes(saved, tmp_path):
    save_model(model(), tmp_path / "other")
    save_model(load_model(saved), tmp_path / "again")
    assert contents(saved) == contents(tmp_path / "other") == contents(tmp_path / "again")
    assert {path.name for path in tmp_path.iterdir()} == {
        f"{name}.{ending}" for name in ("weights", "other", "again") for ending in ("npz", "json")
    }


def test_the_shipped_weights_are_read():
    shipped = load_model(models.WEIGHTS)
    assert shipped.feature_count > 0
    assert all(np.isfinite(factor.weights).all() for factor in shipped.factors.values())


@pytest.mark.parametrize("ending", [".npz", ".json"])
def test_a_missing_file_is_named(saved, ending):
    saved.with_suffix(ending).unlink()
    with pytest.raises(ModelError, match=f"weights{ending}: no such weights"):
        load_model(saved)


def test_another_version_is_refused(saved):
    path = saved.with_suffix(".json")
    path.write_text(json.dumps({**json.loads(path.read_text()), "version": 99}))
    with pytest.raises(ModelError, match="version 99; this program reads version 2"):
        load_model(saved)


@given(st.data())
@settings(max_examples=60)
def test_damaged_numbers_are_refused_or_harmless(tmp_path_factory, data):
    path = tmp_path_factory.mktemp("damaged") / "weights"
    save_model(model(), path)
    content = path.with_suffix(".npz").read_bytes()
    place = data.draw(st.integers(0, len(content) - 1))
    kept = data.draw(st.booleans())
    flip = bytes([content[place] ^ data.draw(st.integers(1, 255))])
    path.with_suffix(".npz").write_bytes(content[:place] + (flip + content[place + 1 :] if kept else b""))
    try:
        again = load_model(path)
    except ModelError:
        pass
    else:  # a flipped bit in what the archive notes beside its content
        assert kept
        for name, factor in model().factors.items():
            np.testing.assert_allclose(again.factors[name].weights, factor.weights, atol=1e-5)


@pytest.mark.parametrize(
    "text",
    [
        "", "{", "[]", "null", '"x"', "{}", '{"version": 2}', '{"version": 2, "notes": {}, "factors": []}',
        '{"version": 2, "factors": {}}', '{"version": 2, "notes": {}, "factors": {"a": {"facts": 3, "roles": []}}}',
        '{"version": 2, "notes": {}, "factors": {"a": []}}', "[" * 100_000,
        '{"version": 2, "notes": {}, "factors": {"strange": {"facts": ["f"], "roles": ["r"]}}}',
        '{"version": 2, "notes": {}, "factors": {"object": {"facts": ["f"], "roles": ["r"]}}}',
    ],
)  # fmt: skip
def test_damaged_names_are_refused(saved, text):
    saved.with_suffix(".json").write_text(text)
    with pytest.raises(ModelError, match="damaged weights"):
        load_model(saved)


class Trap:
    """Pickled, it raises where it is unpickled."""

    def __reduce__(self):
        return (exec, ("raise SystemExit('unpickled')",))


def test_a_pickle_is_never_read(saved):
    saved.with_suffix(".npz").write_bytes(pickle.dumps(Trap()))
    with pytest.raises(ModelError, match="damaged weights"):
        load_model(saved)
    names = np.array([Trap()], dtype=object)
    np.savez(saved.with_suffix(".npz"), **{f"object.{part}": names for part in ("rows", "columns", "weights")})
    with pytest.raises(ModelError, match="damaged weights"):
        load_model(saved)


def with_first_pass(threshold=0.0125):
    weights = np.round(np.random.default_rng(3).normal(size=(4, 2)), 5)
    factor = Factor(("a", "b", "c ä", "d"), ("object", "type"), weights)
    return replace(model(), first_pass=FirstPass(factor, threshold))


@pytest.fixture
def saved_with_first_pass(tmp_path):
    save_model(with_first_pass(), tmp_path / "weights")
    return tmp_path / "weights"


def test_a_first_pass_is_written_and_read(saved_with_first_pass, tmp_path):
    again, written = load_model(saved_with_first_pass).first_pass, with_first_pass().first_pass
    assert again.threshold == written.threshold
    assert (again.factor.facts, again.kinds) == (written.factor.facts, written.kinds)
    np.testing.assert_allclose(again.factor.weights, written.factor.weights, atol=1e-5)
    save_model(load_model(saved_with_first_pass), tmp_path / "again")
    assert contents(saved_with_first_pass) == contents(tmp_path / "again")


def test_a_first_pass_leaves_the_factors_as_they_are(saved, tmp_path):
    save_model(replace(load_model(saved), first_pass=with_first_pass().first_pass), tmp_path / "more")
    with zipfile.ZipFile(saved.with_suffix(".npz")) as before, zipfile.ZipFile(tmp_path / "more.npz") as now:
        for name in before.namelist():
            assert before.read(name) == now.read(name)
    before, now = (json.loads(path.with_suffix(".json").read_text()) for path in (saved, tmp_path / "more"))
    assert {**now, "sha256": before["sha256"]} == {**before, "first_pass": now["first_pass"]}
    assert load_model(saved).first_pass is None


def test_without_a_first_pass_the_files_are_as_before(saved, tmp_path):
    save_model(replace(with_first_pass(), first_pass=None), tmp_path / "none")
    assert contents(saved) == contents(tmp_path / "none")


@pytest.mark.parametrize(
    "damage",
    [
        3, [], {}, None, "x", {"facts": ["a"], "roles": ["object"]}, {"threshold": "much"}, {"threshold": True},
        {"threshold": 1.5}, {"threshold": -1}, {"threshold": None}, {"facts": []}, {"facts": 3},
        {"facts": [1, 2, 3, 4]}, {"roles": None}, {"roles": ["object"]}, {"roles": [[], []]},
    ],
)  # fmt: skip
def test_a_damaged_first_pass_is_refused(saved_with_first_pass, damage):
    path = saved_with_first_pass.with_suffix(".json")
    data = json.loads(path.read_text())
    one_entry = isinstance(damage, dict) and len(damage) == 1
    data["first_pass"] = {**data["first_pass"], **damage} if one_entry else damage
    path.write_text(json.dumps(data))
    with pytest.raises(ModelError, match="damaged weights"):
        load_model(saved_with_first_pass)
