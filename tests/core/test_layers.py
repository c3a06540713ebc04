# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layers: gui -> app -> core, nouns below steps, and what no file may contain."""

from __future__ import annotations

import ast
import importlib
import re
import sys
from functools import cache
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
PACKAGE = REPOSITORY / "millcorr"
CORE = sorted(p for p in PACKAGE.rglob("*.py") if p.relative_to(PACKAGE).parts[0] not in ("app", "gui"))
APP = sorted(PACKAGE.glob("app/*.py"))
GUI = sorted(PACKAGE.glob("gui/*.py"))

HOST = {"FreeCAD", "FreeCADGui", "App", "Gui", "Part", "Sketcher", "Path", "PathScripts", "CAM", "Import", "Draft"}
WINDOW = {"FreeCADGui", "Gui", "PySide", "PySide2", "PySide6", "pivy"}
ROOMS = (
    "messages",
    "errors",
    "options",
    "progress",
    "tolerances",
    "arrays",
    "whole_file",
    "decimal_text",
    "freecad_process",
    "geometry",
    "nc",
    "readers",
    "comparison",
    "separation",
    "plausibility",
    "correction",
    "path",
    "process",
    "probing",
    "stages",
    "pipeline",
    "production",
    "report",
    "virtual",
    "cli",
    "__main__",
    "app",
    "gui",
)
"""A room imports only itself and what stands above it. The files before `geometry` serve all."""
DEPENDENCIES = {"numpy", "scipy", "shapely", "matplotlib"}
OPTIONAL = {"argcomplete", "distributed"}
"""Imported only where they are asked for, with a remedy where they are missing."""

NAMES = {path: ".".join(path.relative_to(REPOSITORY).with_suffix("").parts) for path in [*CORE, *APP, *GUI]}


@cache
def imports(path):
    """Absolute names of everything a module imports, wherever in it; a package's members under their full name."""
    package = NAMES[path].removesuffix(".__init__").split(".")
    if path.name != "__init__.py":
        package = package[:-1]
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            above = package[: len(package) - node.level + 1] if node.level else []
            module = ".".join([*above, *([node.module] if node.module else [])])
            found |= {f"{module}.{alias.name}" for alias in node.names}
        elif isinstance(node, ast.Call) and ast.unparse(node.func) in ("importlib.import_module", "__import__"):
            found |= {a.value for a in node.args if isinstance(a, ast.Constant) and isinstance(a.value, str)}
    return found


def tops(path):
    return {name.partition(".")[0] for name in imports(path)}


def own(path):
    """Modules of millcorr that a module imports, without the package's name."""
    modules = {name.removeprefix("millcorr.") for name in NAMES.values()}
    found = set()
    for name in imports(path):
        if not name.startswith("millcorr."):
            continue
        parts = name.split(".")[1:]
        for n in range(len(parts), 0, -1):
            if ".".join(parts[:n]) in modules or ".".join([*parts[:n], "__init__"]) in modules:
                found.add(".".join(parts[:n]))
                break
    return found


def name(path):
    return NAMES[path].removeprefix("millcorr.")


@pytest.mark.parametrize("path", CORE, ids=name)
def test_core_knows_nothing_of_freecad(path):
    assert not tops(path) & (HOST | WINDOW)
    assert not {module for module in own(path) if module.partition(".")[0] in ("app", "gui")}


@pytest.mark.parametrize("path", CORE, ids=name)
def test_core_needs_only_its_dependencies(path):
    # pathlib's Path is a name, not a module: only what is imported from counts.
    assert tops(path) <= DEPENDENCIES | OPTIONAL | {"millcorr"} | sys.stdlib_module_names


@pytest.mark.parametrize("path", CORE, ids=name)
def test_scipy_is_imported_inside_functions(path):
    """At the top of a module it doubles the time in which every command starts, and a batch starts many."""
    top = ast.parse(path.read_text(encoding="utf-8")).body
    found = [node.module or "" for node in top if isinstance(node, ast.ImportFrom)]
    found += [alias.name for node in top if isinstance(node, ast.Import) for alias in node.names]
    assert not [module for module in found if module.partition(".")[0] == "scipy"]


@pytest.mark.parametrize("path", APP, ids=name)
def test_app_knows_nothing_of_windows(path):
    # Qt's translations are text; windows, scene graph and the window's own module are not.
    assert not tops(path) & WINDOW
    assert not {module for module in own(path) if module.partition(".")[0] == "gui"}


def room(module):
    return module.partition(".")[0]


@pytest.mark.parametrize("path", [*CORE, *APP, *GUI], ids=name)
def test_a_room_imports_only_rooms_above_it(path):
    if name(path) == "__init__":
        return
    allowed = {"__init__", *ROOMS[: ROOMS.index(room(name(path))) + 1]}
    assert {module for module in own(path) if room(module) not in allowed} == set()


def test_every_room_is_on_the_page():
    page = (REPOSITORY / "docs" / "architecture.md").read_text(encoding="utf-8")
    missing = [one for one in ROOMS if f"`{one}`" not in page]
    assert not missing
    assert {path.relative_to(PACKAGE).with_suffix("").parts[0] for path in PACKAGE.rglob("*.py")} - {"__init__"} == set(
        ROOMS
    )


def test_no_module_imports_itself_through_others():
    graph = {name(path): own(path) - {name(path)} for path in [*CORE, *APP, *GUI]}
    seen: dict[str, str] = {}

    def visit(module, trail):
        if seen.get(module) == "done" or module not in graph:
            return
        assert module not in trail, " -> ".join([*trail[trail.index(module) :], module])
        for other in sorted(graph[module]):
            visit(other, [*trail, module])
        seen[module] = "done"

    for module in sorted(graph):
        visit(module, [])


WRITTEN = {".py", ".md", ".toml", ".xml", ".yml", ".yaml", ".txt", ".nc", ".csv", ".svg", ".ui", ".FCMacro", ""}
SKIPPED = {".git", "build", "__pycache__", ".hypothesis", ".pytest_cache", ".mypy_cache", ".ruff_cache"}


def files():
    for path in sorted(REPOSITORY.rglob("*")):
        if path.is_file() and not SKIPPED & set(path.relative_to(REPOSITORY).parts) and path.suffix in WRITTEN:
            yield path


def test_every_source_names_its_licence():
    sources = [p for p in files() if p.suffix in (".py", ".FCMacro", ".md") or p.parent.name in ("tools", ".ci")]
    without = [
        str(path.relative_to(REPOSITORY))
        for path in sources
        if "SPDX-License-Identifier: LGPL-2.1-or-later" not in path.read_text(encoding="utf-8")[:300]
    ]
    assert not without


FORBIDDEN = {
    # Put together here, so that this file does not contain them.
    "a directory of one machine": re.compile(
        r"(?<![\w.\-/$}])/(?:" + "|".join(("work", "root", "home")) + r")(?:/|\b)"
    ),
    "a package registry's host": re.compile(
        "|".join(
            a + r"\." + b
            for a, b in (("pypi", "org"), ("pythonhosted", "org"), ("proxy.golang", "org"), ("npmjs", "com"))
        )
    ),
}
ALLOWED = {
    # Inside a Debian root the user's home is what it is on every Debian.
    (".ci/freecad-root", "HOME=/" + "root"),
    ("tests/freecad_root.py", '"HOME": "/' + 'root"'),
    # A made-up directory that must not get into a program.
    ("tests/core/correction/test_provenance.py", "/" + "home"),
}


@pytest.mark.parametrize("what", FORBIDDEN)
def test_nothing_belongs_to_one_machine(what):
    found = []
    for path in files():
        where = path.relative_to(REPOSITORY).as_posix()
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            if FORBIDDEN[what].search(line) and not any(where == w and part in line for w, part in ALLOWED):
                found.append(f"{where}:{number}: {line.strip()}")
    assert not found


def test_every_page_is_reached_from_the_index():
    docs = REPOSITORY / "docs"
    reached, waiting = set(), [docs / "README.md"]
    while waiting:
        page = waiting.pop()
        if page in reached or docs not in page.parents:
            continue
        reached.add(page)
        for link in re.findall(r"\]\(([^)#\s]+)", page.read_text(encoding="utf-8")):
            if "://" in link:
                continue
            target = (page.parent / link).resolve()
            assert target.exists(), f"{page.relative_to(REPOSITORY)} links to {link}, which is not there"
            if target.suffix == ".md":
                waiting.append(target)
    left = sorted(p.relative_to(docs).as_posix() for p in set(docs.rglob("*.md")) - reached)
    assert not left


SPELLS = {"messages", "cli/arguments", "cli/jobs", "gui/batch_run", "virtual/demonstration"}
"""Modules that write or read a command line."""


@pytest.mark.parametrize("path", [*CORE, *APP, *GUI], ids=NAMES.get)
def test_only_the_command_line_spells_its_options(path):
    """A message names an option by its key (`millcorr.messages`); each front words it."""
    if path.relative_to(PACKAGE).with_suffix("").as_posix() in SPELLS:
        return
    tree = ast.parse(path.read_text(encoding="utf-8"))
    texts = {node for node in ast.walk(tree) if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)}
    documented = {id(node.value) for node in texts}
    keys = "|".join(sorted(map(re.escape, flags()), key=len, reverse=True))
    spelled = [
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in documented
        if re.search(rf"(?<![\w(-])--(?:{keys})(?![\w-])", node.value)
    ]
    assert spelled == []


@cache
def flags():
    """Options of every verb, without their dashes."""
    from millcorr.cli.arguments import verbs

    return {text.lstrip("-") for verb in verbs().values() for action in verb._actions for text in action.option_strings}


def test_every_key_in_a_message_is_an_option():
    from millcorr.messages import flag

    used = set()
    for path in [*CORE, *APP, *GUI]:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("option", "remedy") and node.args:
                if isinstance(node.args[0], ast.Constant):
                    used.add(node.args[0].value)
    assert {key for key in used if flag(key).lstrip("-") not in flags()} == set()


def _module(parts):
    """File of a module by its name within the package; a package is its directory; None where there is neither."""
    place = PACKAGE.joinpath(*parts)
    return place if place.is_dir() else next(iter(p for p in [place.with_suffix(".py")] if p.is_file()), None)


def test_the_glossary_names_what_there_is():
    """Each name of the code in it can be imported; app needs FreeCAD, so its source is asked."""
    page = (REPOSITORY / "docs" / "glossary.md").read_text(encoding="utf-8")
    named = re.findall(r"(?<=[|,] )`([a-z_]+(?:\.\w+)+)`", page)
    assert len(named) > 40
    missing = []
    for name in named:
        parts = name.split(".")
        whole = [k for k in range(1, len(parts) + 1) if _module(parts[:k]) is not None]
        depth = max(whole)
        if parts[0] == "app":
            source = _module(parts[:depth]).read_text(encoding="utf-8")
            missing += [] if depth == len(parts) or f"class {parts[-1]}" in source else [name]
            continue
        there = importlib.import_module(".".join(["millcorr", *parts[:depth]]))
        for part in parts[depth:]:
            there = getattr(there, part, None)
        missing += [] if there is not None else [name]
    assert missing == []
