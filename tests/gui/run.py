# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smoke test of the workbench in FreeCAD's window, under Xvfb.

    python3 tests/gui/run.py [--root DIR] [--shots DIR]

Makes the demonstration, corrects it without a window, opens the result with one. `--root` takes the FreeCAD of
a Debian root; pictures of the window go to `--shots` (default build/screenshots).
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

_PREPARE = """
import os, sys
def _run():
    if os.path.exists({work!r} + "/cmm.csv"):
        return
    tag, directory = {packages!r}.split(os.pathsep, 1)
    if tag == sys.implementation.cache_tag:
        sys.path.insert(0, directory)
    sys.path[0:0] = [{repository!r}, {repository!r} + "/tests/app"]
    from pathlib import Path
    from conftest import write_measurement
    from millcorr.app import batch, compat, demonstration, documents, motion
    work = Path({work!r})
    demonstration.make(work / "demo.FCStd", work / "demo.nc")
    with documents.opened(work / "demo.FCStd") as doc:
        program = motion.program_of_path(compat.path_of(batch.find_operation(doc)), "demo")
    write_measurement(work / "cmm.csv", program, demonstration.TOOL_DIAMETER / 2)
    batch.correct_document(
        work / "demo.FCStd", measured=work / "cmm.csv", points="contact", output=work / "corrected.FCStd",
        filter="mean:5",
    )
_run()
"""


def main() -> int:
    """Run the test; 0 if all went well."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--root")
    parser.add_argument("--shots", default=str(freecad_root.REPOSITORY / "build" / "screenshots"))
    options = parser.parse_args()
    shots = Path(options.shots)
    shots.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="millcorr-gui-") as directory:
        work = Path(directory)
        (work / "shots").mkdir()
        user = freecad_root.user_data(work)
        prepare = work / "prepare_millcorr.py"
        prepare.write_text(
            _PREPARE.format(work=directory, packages=freecad_root.packages(), repository=str(freecad_root.REPOSITORY)),
            encoding="utf-8",
        )
        settings = work / "user.cfg"
        settings.write_text(_SETTINGS, encoding="utf-8")
        environment = {"FREECAD_USER_DATA": str(user), "PYTHONDONTWRITEBYTECODE": "1"}
        done = freecad_root.run(
            ["freecadcmd", str(prepare)], work, options.root, QT_QPA_PLATFORM="offscreen", **environment
        )
        if not (work / "corrected.FCStd").exists():
            print(done.stdout.decode("utf-8", "replace")[-2000:], done.stderr.decode("utf-8", "replace")[-2000:])
            return 3
        environment |= {"MILLCORR_WORK": directory, "MILLCORR_SHOTS": str(work / "shots")}
        if options.root is None:
            # FreeCAD's window forgets PYTHONPATH; the addon manager puts packages here.
            (user / "AdditionalPythonPackages").symlink_to(freecad_root.packages().split(":", 1)[1])
        script = HERE / "inside_freecad.py"
        done = freecad_root.run(
            [
                "timeout",
                "240",
                "xvfb-run",
                "-a",
                "-s",
                "-screen 0 1400x900x24",
                "freecad",
                "-u",
                str(settings),
                str(script),
            ],
            work,
            options.root,
            **environment,
        )
        version = "unknown"
        for shot in sorted((work / "shots").iterdir()):
            (shots / shot.name).write_bytes(shot.read_bytes())
        if not (work / "found.json").exists():
            print(done.stdout.decode("utf-8", "replace")[-3000:], done.stderr.decode("utf-8", "replace")[-3000:])
            print("FreeCAD's window gave no answer")
            return 3
        found = json.loads((work / "found.json").read_text(encoding="utf-8"))
    version = found["version"]
    wrong = check(found)
    for text in wrong:
        print(f"FreeCAD {version}: {text}")
    if wrong:
        print(json.dumps(found, indent=1))
    else:
        print(f"FreeCAD {version}: the window shows the corrected job; pictures in {shots}")
    return 1 if wrong else 0


def check(found: dict) -> list[str]:
    """What is not as it should be."""
    if "error" in found:
        return [found["error"]]
    expected = {
        "workbench": True,
        "commands": ["Millcorr_Dressup", "Millcorr_Measurement", "Millcorr_Profile", "Millcorr_Report"],
        "visible": [True, False],
        "proxy": "DressupMillcorr",
        "view": "DressupView",
        "children": ["Profile"],
        "icons": True,
        "valid": True,
        "profile": 1,
        "undone": True,
        "refused": True,
        "deleted": ["Profile"],
    }
    found["commands"] = sorted(found["commands"])
    wrong = [f"{k} is {found.get(k)!r} instead of {v!r}" for k, v in expected.items() if found.get(k) != v]
    # Headless and with a window FreeCAD may have different numpys.
    if found["same"] > 1e-5:
        wrong.append(f"recomputing changed the path by {found['same']} mm")
    if not all(found["active"].values()):
        wrong.append(f"commands are not usable: {found['active']}")
    if found["tree"].get("Profile corrected") != ["Profile"]:
        wrong.append("the tree does not show the operation below the dressup")
    if not any("Profile corrected" in found["tree"].get(child, []) for child in found["tree"].get("Job", [])):
        wrong.append("the tree does not show the dressup in the job")
    if found["posted"][:2] != [1, True] or not found["posted"][2]:
        wrong.append(f"posting: {found['posted']}")
    return wrong


if __name__ == "__main__":
    sys.exit(main())
