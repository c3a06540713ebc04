# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run the tests of this directory with pytest inside FreeCADCmd.

    python3 tests/app/run.py [--root DIR] [--documents DIR] [pytest arguments]

`--root` runs them on the FreeCAD of a Debian root; `--documents` keeps the documents that one version writes
there and lets the next one open them. FreeCAD's own exit status says nothing: the tests' goes through a file.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import freecad_root  # noqa: E402

_SCRIPT = """\
import os, sys, traceback
def _run():
    work = {work!r}
    if os.path.exists(work + "/log.txt"):
        return  # FreeCADCmd runs a script again when it raised
    with open(work + "/log.txt", "w", encoding="utf-8") as log:
        sys.stdout = sys.stderr = log
        try:
            tag, directory = {packages!r}.split(os.pathsep, 1)
            if tag == sys.implementation.cache_tag:
                sys.path.insert(0, directory)
            sys.path.insert(0, {repository!r})
            os.environ["MILLCORR_DOCUMENTS"] = {documents!r}
            import FreeCAD, numpy, pytest
            version = ".".join(FreeCAD.Version()[:3])
            print("FreeCAD", version, "Python", sys.version.split()[0], "numpy", numpy.__version__)
            status = int(pytest.main({arguments!r}))
        except BaseException:
            traceback.print_exc()
            status = 3
        finally:
            sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
    with open(work + "/status", "w") as stream:
        stream.write(str(status))
_run()
"""


def main() -> int:
    """Run the tests; gives pytest's exit status."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--root")
    parser.add_argument("--documents")
    options, arguments = parser.parse_known_args()
    with tempfile.TemporaryDirectory(prefix="millcorr-tests-") as directory:
        work = Path(directory)
        documents = Path(options.documents or directory).resolve() / "documents"
        documents.mkdir(parents=True, exist_ok=True)
        inside = work / "documents"
        if documents != inside:
            # The root sees the work directory only: what other versions wrote goes in, what this one wrote out.
            inside.mkdir()
            _copy(documents, inside)
        script = work / "millcorr_tests.py"
        chosen = arguments if any(Path(a.split("::")[0]).exists() for a in arguments) else [str(HERE), *arguments]
        script.write_text(
            _SCRIPT.format(
                work=directory,
                packages=freecad_root.packages(),
                repository=str(freecad_root.REPOSITORY),
                documents=str(inside),
                arguments=[
                    "--rootdir",
                    str(freecad_root.REPOSITORY),
                    "-p",
                    "no:cacheprovider",
                    "-p",
                    "no:faulthandler",
                    "--color=no",
                    "-W",
                    "ignore::DeprecationWarning",
                    *chosen,
                ],  # fmt: skip
            ),
            encoding="utf-8",
        )
        done = freecad_root.run(
            ["freecadcmd", str(script)],
            work,
            options.root,
            FREECAD_USER_DATA=str(freecad_root.user_data(work)),
            QT_QPA_PLATFORM="offscreen",
            PYTHONDONTWRITEBYTECODE="1",
        )
        log, status = work / "log.txt", work / "status"
        if log.exists():
            print(log.read_text(encoding="utf-8"))
        if not status.exists():
            print(done.stdout.decode("utf-8", "replace")[-3000:], done.stderr.decode("utf-8", "replace")[-3000:])
            print("FreeCADCmd ended before the tests did")
            return 3
        if documents != inside:
            _copy(inside, documents)
        return int(status.read_text())


def _copy(source: Path, target: Path) -> None:
    for file in source.iterdir():
        if file.is_file():
            (target / file.name).write_bytes(file.read_bytes())


if __name__ == "__main__":
    sys.exit(main())
