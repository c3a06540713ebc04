# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stories of a user in FreeCAD's window, under Xvfb.

    python3 tests/gui/run.py [--root DIR] [--shots DIR] [--screen 1400x900] [--look light] [STORY ...]

Makes the demonstration without a window, then plays each story (all of them by default) in a FreeCAD of its own.
`--root` takes the FreeCAD of a Debian root; pictures go to `--shots` (default build/screenshots); `--look` is that of
the window in German.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import freecad_root  # noqa: E402

PLAYS = 2
"""A story without an answer is played so many times in all; one that finds something wrong is not."""

STORIES = ("saved", "correct", "session", "large", "shop", "tutorial", "language", "picture")

REPLAYED = ("correct", "session", "shop")
"""Stories whose recorded lines run without a window afterwards."""

# A modal window that nobody answers hangs the test: the web start page, the unit schema's warning.
_SETTINGS = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText></FCParamGroup>
<FCParamGroup Name="Units"><FCInt Name="UserSchema" Value="6"/></FCParamGroup>
<FCParamGroup Name="Mod"><FCParamGroup Name="Start"><FCBool Name="FirstStart2024" Value="0"/>
<FCBool Name="ShowOnStartup" Value="0"/></FCParamGroup>
<FCParamGroup Name="Path"><FCBool Name="WarningSuppressAllSpeeds" Value="1"/>
<FCBool Name="WarningSuppressVelocity" Value="1"/></FCParamGroup>
<FCParamGroup Name="CAM"><FCBool Name="WarningSuppressAllSpeeds" Value="1"/>
<FCBool Name="WarningSuppressVelocity" Value="1"/></FCParamGroup></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""

_HEADLESS = """
import os, sys, traceback
def _run():
    tag, directory = {packages!r}.split(os.pathsep, 1)
    if tag == sys.implementation.cache_tag:
        sys.path.insert(0, directory)
    sys.path[0:0] = [{repository!r}, {here!r}]
    import headless
    try:
        headless.{function}({work!r})
    except Exception:
        traceback.print_exc()
        return
    open({done!r}, "w").close()
_run()
"""


class Stage:
    """A work directory with a FreeCAD user, and how FreeCAD is started in it."""

    def __init__(self, work: Path, root: str | None, screen: str, look: str) -> None:
        self.work, self.root, self.screen, self.look = work, root, screen, look
        self.shots = work / "shots"
        self.shots.mkdir()
        user = freecad_root.user_data(work)
        self.settings = work / "user.cfg"
        self.settings.write_text(_SETTINGS, encoding="utf-8")
        self.environment = {"FREECAD_USER_DATA": str(user), "PYTHONDONTWRITEBYTECODE": "1"}
        if root is None:
            # FreeCAD's window forgets PYTHONPATH; the addon manager puts packages here.
            (user / "AdditionalPythonPackages").symlink_to(freecad_root.packages().split(":", 1)[1])

    def headless(self, function: str) -> str:
        """Run a function of headless.py in FreeCADCmd; what went wrong, or nothing."""
        done = self.work / f"{function}.done"
        script = self.work / f"run_{function}.py"
        text = _HEADLESS.format(
            done=str(done),
            packages=freecad_root.packages(),
            repository=str(freecad_root.REPOSITORY),
            here=str(HERE),
            function=function,
            work=str(self.work),
        )
        script.write_text(text, encoding="utf-8")
        ran = freecad_root.run(
            ["freecadcmd", str(script)], self.work, self.root, QT_QPA_PLATFORM="offscreen", **self.environment
        )
        return "" if done.exists() else (ran.stdout[-2000:] + ran.stderr[-2000:]).decode("utf-8", "replace")

    def play(self, story: str) -> dict:
        """Play a story in the window; what it found."""
        answer = self.work / "found.json"
        answer.unlink(missing_ok=True)
        screen = ["xvfb-run", "-a", "-s", f"-screen 0 {self.screen}x24"]
        start = ["freecad", "-u", str(self.settings), str(HERE / f"story_{story}.py")]
        # The script's own directory is not on FreeCAD's path.
        names = {
            "WORK": str(self.work),
            "SHOTS": str(self.shots),
            "STORY": story,
            "TESTS": str(HERE),
            "LOOK": self.look,
        }
        environment = {f"MILLCORR_{name}": value for name, value in names.items()} | self.environment
        # FreeCAD 1.1 has broken down inside its own task view, once in several plays of a story and never twice.
        for _ in range(PLAYS):
            ran = freecad_root.run(["timeout", "900", *screen, *start], self.work, self.root, **environment)
            if answer.exists():
                return json.loads(answer.read_text(encoding="utf-8"))
            print((ran.stdout[-3000:] + ran.stderr[-8000:]).decode("utf-8", "replace"))
            print(f"{story}: FreeCAD's window gave no answer", flush=True)
        return {"version": "unknown", "wrong": ["FreeCAD's window gave no answer"], "figures": {}}


def main() -> int:
    """Play the stories; 0 if all went well."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--root")
    parser.add_argument("--shots", default=str(freecad_root.REPOSITORY / "build" / "screenshots"))
    parser.add_argument("--screen", default="1400x900", help="its size in pixels")
    parser.add_argument("--look", default="dark", choices=("dark", "light"), help="of the window in German")
    parser.add_argument("stories", nargs="*", metavar="STORY", help=", ".join(STORIES))
    options = parser.parse_args()
    unknown = sorted(set(options.stories) - set(STORIES))
    if unknown:
        parser.error(f"there is no story {unknown[0]}: {', '.join(STORIES)}")
    shots = Path(options.shots)
    shots.mkdir(parents=True, exist_ok=True)
    failed = False
    with tempfile.TemporaryDirectory(prefix="millcorr-gui-") as directory:
        stage = Stage(Path(directory), options.root, options.screen, options.look)
        trouble = stage.headless("prepare")
        if trouble:
            print(trouble)
            return 3
        for story in options.stories or STORIES:
            found = stage.play(story)
            if story in REPLAYED and not found["wrong"]:
                trouble = stage.headless(f"replay_{story}")
                found["wrong"] += [f"the recorded lines do not run without a window: {trouble}"] if trouble else []
            for shot in stage.shots.iterdir():
                (shots / shot.name).write_bytes(shot.read_bytes())
            for text in found["wrong"]:
                print(f"FreeCAD {found['version']}, {story}: {text}")
            failed |= bool(found["wrong"])
            figures = {k: v for k, v in found["figures"].items() if k != "version"}
            verdict = "not as it should be" if found["wrong"] else "as it should be"
            print(f"FreeCAD {found['version']}, {story}: {verdict} {json.dumps(figures) if figures else ''}")
    print(f"pictures in {shots}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
