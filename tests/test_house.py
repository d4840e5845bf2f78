"""The house is in order: who may import whom, no circles, and folders, modules and functions of a size one can read."""

import ast
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PACKAGES = ("grounding", "motion", "integration", "models")
MAY_IMPORT = {
    "grounding": {"grounding", "models"},
    "motion": {"motion", "models"},
    "integration": {"integration", "motion", "grounding", "models"},
    "models": {"models"},
}
CHECKED = ("motion", "integration")
"""Packages whose files form no circles and keep to the sizes below. Grounding has circles and is being rebuilt; when
it is done, it joins them."""
ROOMS = ("factors", "lexicon", "literal", "meaning", "model", "placing", "world")
WITHOUT_CIRCLES = (*CHECKED, *(f"grounding/{room}" for room in ROOMS))
"""Packages, and rooms of grounding, whose files form no circles."""
MODULES_A_FOLDER = 16
LINES_A_MODULE = 350
LINES_A_FUNCTION = 60
COMPLEXITY = 12


@cache
def modules(package):
    """Every module of a package by its dotted name; a folder's own name is its `__init__`."""
    found = {}
    for path in sorted((ROOT / package).rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


@cache
def imported(path):
    """What a file imports as (module, name or None), also within functions and for types alone."""
    found = []
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            found += [(alias.name, None) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            parts = path.relative_to(ROOT).parts[: -node.level] if node.level else ()
            base = ".".join((*parts, *filter(None, [node.module])))
            found += [(base, alias.name) for alias in node.names]
    return found


def neighbours(name, known):
    """The modules among `known` that one of them imports."""
    found = set()
    for base, part in imported(known[name]):
        whole = f"{base}.{part}"
        found.add(whole if whole in known else base)
    return sorted((found & set(known)) - {name})


def circles(graph):
    """The strongly connected components with more than one node (Tarjan, 1972), each sorted."""
    order, low, stack, found = {}, {}, [], []

    def visit(node):
        order[node] = low[node] = len(order)
        stack.append(node)
        for other in graph[node]:
            if other not in order:
                visit(other)
            if other in stack:
                low[node] = min(low[node], low[other])
        if low[node] == order[node]:
            place = stack.index(node)
            if len(stack) - place > 1:
                found.append(sorted(stack[place:]))
            del stack[place:]

    for node in graph:
        if node not in order:
            visit(node)
    return found


def room(name, known):
    """The folder directly below its package that a module is in, or None for what stands at the package's door."""
    parts = name.split(".")
    inside = len(parts) > 2 or (len(parts) == 2 and known[name].name == "__init__.py")
    return ".".join(parts[:2]) if inside else None


def functions(path):
    """Every function of a file, also those within classes and functions."""
    return [node for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.FunctionDef)]


@pytest.mark.parametrize("package", PACKAGES)
def test_packages_import_only_what_is_below_them(package):
    for path in modules(package).values():
        used = {base.split(".")[0] for base, _ in imported(path)} & set(PACKAGES)
        assert used <= MAY_IMPORT[package], f"{path.relative_to(ROOT)} imports {used - MAY_IMPORT[package]}"


def test_circles_are_found():
    assert circles({"a": ["b"], "b": ["c"], "c": ["b"], "d": ["a", "d"]}) == [["b", "c"]]
    assert circles({"a": ["b", "c"], "b": ["c"], "c": []}) == []
    assert circles({"a": ["b"], "b": ["c"], "c": ["a"], "d": ["c", "e"], "e": ["d"]}) == [["a", "b", "c"], ["d", "e"]]


@pytest.mark.parametrize("package", WITHOUT_CIRCLES)
def test_no_files_import_one_another_in_a_circle(package):
    known = modules(package)
    assert circles({name: neighbours(name, known) for name in known}) == []


@pytest.mark.parametrize("package", CHECKED)
def test_no_folders_import_one_another_in_a_circle(package):
    known = modules(package)
    graph = {folder: set() for folder in sorted({room(name, known) for name in known} - {None})}
    for name in known:
        here = room(name, known)
        if here is not None:
            graph[here] |= {room(other, known) for other in neighbours(name, known)} - {None, here}
    assert circles({folder: sorted(others) for folder, others in graph.items()}) == []


@pytest.mark.parametrize("package", CHECKED)
def test_a_folder_has_few_modules(package):
    known = modules(package)
    for folder in sorted({path.parent for path in known.values()}):
        inside = [path for path in known.values() if path.parent == folder]
        assert len(inside) <= MODULES_A_FOLDER, f"{folder.relative_to(ROOT)} has {len(inside)} modules"
        assert folder / "__init__.py" in inside, f"{folder.relative_to(ROOT)} has no __init__.py"


@pytest.mark.parametrize("package", CHECKED)
def test_docstrings_begin_with_a_noun_or_a_verb(package):
    for name, path in modules(package).items():
        tree = ast.parse(path.read_text())
        assert ast.get_docstring(tree), f"{name} does not say what it is for"
        for node in ast.walk(tree):
            if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
                first = (ast.get_docstring(node) or "-").split()[0]
                assert first not in ("What", "How", "Why", "Where", "Whether", "Which"), f"{name}: {first} ..."


@pytest.mark.parametrize("package", CHECKED)
def test_modules_and_functions_can_be_read_in_one_go(package):
    for path in modules(package).values():
        lines = len(path.read_text().splitlines())
        assert lines <= LINES_A_MODULE, f"{path.relative_to(ROOT)} has {lines} lines"
        for function in functions(path):
            lines = function.end_lineno - function.lineno + 1
            assert lines <= LINES_A_FUNCTION, f"{path.relative_to(ROOT)}: {function.name} has {lines} lines"


def test_functions_have_few_branches():
    limit = f"lint.mccabe.max-complexity={COMPLEXITY}"
    command = [sys.executable, "-m", "ruff", "check", "--select", "C901", "--config", limit, *CHECKED]
    result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr


def test_a_name_stands_for_one_thing():
    """Modules, and public functions and classes, of all checked packages; a command is named after what it is about."""
    conventional = {"__init__", "__main__", "errors", "main", "run"}
    known = {name: path for package in CHECKED for name, path in modules(package).items() if ".commands." not in name}
    places = {}
    for name, path in known.items():
        public = {path.stem}
        for node in ast.parse(path.read_text()).body:
            if isinstance(node, ast.ClassDef | ast.FunctionDef) and not node.name.startswith("_"):
                public.add(node.name)
        for one in public - conventional:
            places.setdefault(one, []).append(name)
    assert {one: found for one, found in places.items() if len(found) > 1} == {}


@pytest.mark.parametrize(("page", "package"), [("motion", "motion"), ("kinematics", "motion"), ("integration", ".")])
def test_modules_that_a_page_names_are_there(page, package):
    for name in re.findall(r"`([\w/]+\.py)`", (ROOT / "docs" / f"{page}.md").read_text()):
        assert (ROOT / package / name).is_file(), f"docs/{page}.md names {name}"
