# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress and stop: what is heard of a correction, and that stopping it anywhere leaves either all or nothing."""

from __future__ import annotations

import threading
import time

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from millcorr import nc, pipeline, progress
from millcorr.cli import verbs
from millcorr.correction.settings import Settings
from millcorr.progress import STAGES, Stopped
from millcorr.readers import Reading
from tests.core.paper_2023 import PROGRAM, SETUP

DISC = "G21 G90 G17\nG0 X45 Y0 Z5\nG1 Z-8 F100\nG2 X-45 Y0 I-45 J0 F300\nG2 X45 Y0 I45\nG0 Z5\nM2\n"
HONOURED = 0.5
"""Seconds within which a stop is honoured."""


def points(path, count, seed=3):
    rng = np.random.default_rng(seed)
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    radius = 40.0 + 0.004 * np.cos(2 * angle) + rng.normal(0, 0.0003, count)
    table = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.full(count, -6.0)])
    path.write_text("x,y,z\n" + "".join(f"{x:.5f},{y:.5f},{z:.5f}\n" for x, y, z in table.tolist()), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def shop(tmp_path_factory):
    here = tmp_path_factory.mktemp("shop")
    (here / "disc.nc").write_text(DISC, encoding="utf-8")
    (here / "part.nc").write_text(PROGRAM, encoding="utf-8")
    points(here / "few.csv", 90)
    points(here / "many.csv", 300_000)
    return here


def correct(shop, *, measured="few.csv", **more):
    asked = verbs.CorrectionAsked(
        [shop / measured], Reading(points="contact"), tool_diameter=10.0, settings=Settings(side="left"), **more
    )
    return verbs.correct_program(shop / "disc.nc", asked)


def simulate(shop):
    return verbs.simulate_program(
        shop / "part.nc", setup=SETUP, report=shop / "simulated", settings=Settings(method="predicted", side="left")
    )


def heard(function):
    seen = []
    with progress.heard(lambda stage, share: seen.append((stage, share))):
        function()
    return seen


@pytest.mark.few(1)
@pytest.mark.parametrize(("work", "stages"), [(correct, {"read", "separate", "write"}), (simulate, {"simulate"})])
def test_stages_are_named_and_the_share_never_falls(shop, work, stages):
    seen = heard(lambda: work(shop))
    assert stages <= {stage for stage, _ in seen} <= {"", *STAGES}
    shares = [share for _, share in seen]
    assert shares == sorted(shares) and shares[0] >= 0 and shares[-1] <= 1


def test_nobody_hears_what_nobody_asked_for(shop):
    seen = heard(lambda: None)
    correct(shop)
    assert seen == []


def test_nobody_catches_a_stop_by_mistake():
    assert not issubclass(Stopped, Exception)


@pytest.fixture(scope="module")
def whole(shop):
    """A correction that nobody stops, and how many steps it has."""
    return shop / "whole.nc", len(heard(lambda: correct(shop, output=shop / "whole.nc", report=shop / "whole")))


@example(back=0)
@example(back=1)
@example(back=2)
@given(back=st.one_of(st.integers(0, 12), st.integers(0, 1_000)))
def test_stopped_anywhere_all_is_as_before_or_all_is_done(shop, whole, tmp_path_factory, back):
    """Stopped at any step either nothing is written and nothing said, or everything is and it is said."""
    here = tmp_path_factory.mktemp("out")
    output, report = here / "out.nc", here / "report"
    output.write_text("before", encoding="utf-8")
    program, steps = whole
    left = [max(steps - back, 0)]

    def hear(stage, share):
        left[0] -= 1
        if left[0] < 0:
            raise Stopped

    try:
        with progress.heard(hear):
            words = correct(shop, output=output, report=report)
    except Stopped:
        assert output.read_text(encoding="utf-8") == "before" and not report.exists()
        assert sorted(p.name for p in here.iterdir()) == ["out.nc"]
    else:
        assert str(output) in words and (report / "report.html").is_file()
        assert nc.read(output).toolpath.end.shape == nc.read(program).toolpath.end.shape


def test_a_stop_is_honoured_soon(shop):
    """No stretch of work without a step is as long as that, of 300,000 points; in processor time, which is whole."""
    last, longest = [time.thread_time()], [0.0]

    def hear(stage, share):
        now = time.thread_time()
        longest[0] = max(longest[0], now - last[0])
        last[0] = now

    with progress.heard(hear):
        correct(shop, measured="many.csv")
        hear("", 1.0)
        simulate(shop)
    hear("", 1.0)
    assert longest[0] < HONOURED


def test_who_hears_is_another_in_every_thread():
    seen, ready = [], threading.Barrier(2)

    def work(name):
        with progress.heard(lambda stage, share: seen.append((name, stage))):
            ready.wait(10)
            progress.stage("draw" if name else "read")

    threads = [threading.Thread(target=work, args=(name,)) for name in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(seen) == [(0, "read"), (1, "draw")]


def test_a_kept_result_is_that_of_work_that_ended():
    """Whoever stops gets no half result: the same request gives the same as if it had never been begun."""
    from millcorr.readers.measurement import Measurement

    angle = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    table = (40.0 + 0.004 * np.cos(2 * angle))[:, None] * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    measured = Measurement(table, None, 0.0, np.arange(1, 61), "disc.csv", "0", has_z=False)
    request = pipeline.Request(nc.parse(DISC, "disc.nc"), 5.0, measured, None, Settings(side="left"))
    whole = pipeline.correct(request).text

    def hear(stage, share):
        if stage == "separate":
            raise Stopped

    with pytest.raises(Stopped), progress.heard(hear):
        pipeline.correct(request)
    assert pipeline.correct(request).text == whole
