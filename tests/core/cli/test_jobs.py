# SPDX-License-Identifier: LGPL-2.1-or-later
"""Batches: many commands from one file, each in its own process."""

from __future__ import annotations

import io
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.__main__ import main
from millcorr.cli import jobs
from millcorr.errors import FormatError, MillcorrError, UsageError
from millcorr.production import journal
from tests.core import loop_programs as programs

REPOSITORY = Path(__file__).resolve().parents[3]


@pytest.fixture
def shop(tmp_path):
    """Directory with one program and the measurements of three parts."""
    (tmp_path / "part.nc").write_text(programs.RECTANGLE)
    nominal = pipeline.nominal_from_program(
        nc.read(tmp_path / "part.nc"), programs.RADIUS, pipeline.Settings(side="right"), None
    )
    for number in (1, 2, 3):
        points = programs.measured(nominal, lambda k, s, n=number: 0.004 * n + 0.003 * np.sin(s / 9.0)).points
        rows = "\n".join(f"{x:.7f},{y:.7f},{z:.3f}" for x, y, z in points)
        (tmp_path / f"cmm{number}.csv").write_text(f"x,y,z\n{rows}\n")
    return tmp_path


DEFAULTS = """\
[defaults]
tool-diameter = 10
points = "contact"
filter = "none"
"""
JOB = """
[[job]]
name = "{name}"
program = "part.nc"
measured = "{measured}"
output = "{name}.nc"
"""
# Where only the keeping of books matters: a third of the time.
CONVERT = """
[[job]]
name = "{name}"
verb = "convert"
measured = "{measured}"
output = "{name}.csv"
"""


def batch(shop, *rows):
    path = shop / "night.toml"
    path.write_text(DEFAULTS + "".join(rows))
    return path


def three(shop):
    return batch(shop, *(CONVERT.format(name=f"out{n}", measured=f"cmm{n}.csv") for n in (1, 2, 3)))


def test_jobs_do_what_the_commands_do_and_one_failure_stops_no_other(shop):
    path = batch(
        shop,
        JOB.format(name="out1", measured="cmm1.csv"),
        JOB.format(name="bad", measured="missing.csv"),
        JOB.format(name="out3", measured="cmm3.csv"),
        '\n[[job]]\nname = "look"\nverb = "check"\nprogram = "part.nc"\nmeasured = ["cmm1.csv", "cmm2.csv"]\n'
        'report = "looked"\n',
    )
    out = io.StringIO()
    done = jobs.run(path, workers=2, out=out)
    assert [(o.name, o.status) for o in done] == [("out1", 0), ("bad", 3), ("out3", 0), ("look", 0)]
    assert "missing.csv" in done[1].text and len(done[1].text.splitlines()) == 1
    assert not (shop / "bad.nc").exists() and (shop / "looked" / "report.html").exists()
    assert jobs.exit_status(done) == 3 and "3 of 4 jobs done" in jobs.in_words(done)
    lines = out.getvalue().splitlines()
    assert len(lines) == 4 and all(line.startswith("[") for line in lines)
    common = ["--tool-diameter", "10", "--points", "contact", "--filter", "none"]
    measured = ["--measured", str(shop / "cmm3.csv"), "--output", str(shop / "alone.nc")]
    assert main(["correct", "--program", str(shop / "part.nc"), *common, *measured]) == 0
    one, other = ((shop / name).read_text().splitlines() for name in ("out3.nc", "alone.nc"))
    assert [a for a, b in zip(one, other, strict=True) if a != b and "cmm3.csv" not in a] == []


def test_second_run_does_only_what_is_left(shop):
    path = three(shop)
    (shop / "cmm2.csv").rename(shop / "later.csv")
    assert [o.status for o in jobs.run(path, out=io.StringIO())] == [0, 3, 0]
    written = (shop / "out1.csv").stat().st_mtime_ns
    (shop / "later.csv").rename(shop / "cmm2.csv")
    (shop / "out3.csv").unlink()
    again = jobs.run(path, out=io.StringIO())
    assert [(o.status, o.before) for o in again] == [(0, True), (0, False), (0, False)]
    assert (shop / "out1.csv").stat().st_mtime_ns == written
    # What goes in has changed: the job is new.
    (shop / "cmm1.csv").write_text((shop / "cmm3.csv").read_text())
    assert [o.before for o in jobs.run(path, out=io.StringIO())] == [False, True, True]
    path = batch(shop, CONVERT.format(name="out2", measured="cmm2.csv"))
    assert [o.before for o in jobs.run(path, out=io.StringIO())] == [True]
    assert [o.before for o in jobs.run(path, again=True, out=io.StringIO())] == [False]


def test_killed_batch_is_resumed(shop):
    path = three(shop)
    command = [sys.executable, "-m", "millcorr", "batch", str(path), "--jobs", "1"]
    process = subprocess.Popen(command, cwd=REPOSITORY, stdout=subprocess.PIPE, text=True, start_new_session=True)
    assert process.stdout.readline().startswith("[1/3] ok")
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    assert process.returncode == -signal.SIGKILL
    assert sum((shop / f"out{n}.csv").exists() for n in (1, 2, 3)) < 3
    done = jobs.run(path, out=io.StringIO())
    assert [o.status for o in done] == [0, 0, 0] and done[0].before
    assert sum(o.before for o in done) < 3


@pytest.mark.thorough
def test_torn_record_is_done_again(shop):
    path = batch(shop, *(CONVERT.format(name=f"out{n}", measured=f"cmm{n}.csv") for n in (1, 2)))
    jobs.run(path, out=io.StringIO())
    state = shop / "night.toml.state"
    state.write_bytes(state.read_bytes()[:-20])
    assert sum(o.before for o in jobs.run(path, out=io.StringIO())) == 1
    assert all(o.before for o in jobs.run(path, out=io.StringIO()))


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.mark.thorough
def test_bar_over_all_on_a_terminal(shop):
    out = Terminal()
    jobs.run(three(shop), out=out)
    assert "[..............................] 0/3" in out.getvalue()
    assert "[####################..........] 2/3" in out.getvalue()
    assert out.getvalue().endswith("\r")


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "at least one table"),
        ("job = 3", "at least one table"),
        ("[[job]]\nverb = 'mill'", "verb is one of correct"),
        ("[[job]]\nverb = 'batch'", "verb is one of correct"),
        ("[[job]]\nprogram = 'a.nc'\nmeasured = 'b.csv'\noutput = 'c.nc'\ncolour = 'red'", "colour is no option"),
        ("[defaults]\ncolour = 'red'\n[[job]]\nprogram='a.nc'\nmeasured='b.csv'\noutput='c.nc'", "colour is no option"),
        ("[[job]]\nprogram = 'a.nc'\noutput = 'c.nc'", "job 1: the following arguments are required: --measured"),
        ("[[job]]\nprogram='a.nc'\nmeasured='b.csv'\noutput='c.nc'\ngain='much'", "invalid float value: 'much'"),
        ("[[job]]\nprogram='a.nc'\nmeasured='b.csv'\noutput='c.nc'\ngain=[1,2]", "gain = \\[1, 2\\] is not possible"),
        ("[[job]]\nprogram='a.nc'\nmeasured='b.csv'\noutput='c.nc'\nwork-offset=[1,2]", "work-offset"),
        ("[[job]]\nname = 'a'\nprogram='a.nc'\nmeasured='b.csv'\noutput='c.nc'\n" * 2, "two jobs have this name"),
        ("[[job]]\nprogram='a.nc'\nmeasured='b.csv'\noutput='c.nc'\n" * 2, "job 1 and job 2 both write"),
        (
            "[[job]]\nprogram='a.nc'\nmeasured='b.csv'\noutput='c.nc'\n"
            "[[job]]\nprogram='c.nc'\nmeasured='d.csv'\noutput='e.nc'",
            "which job 1 writes",
        ),
        ("[[job]", "no TOML"),
        ("jobs = 1", "jobs is not known"),
    ],
)
def test_batch_that_cannot_be_is_refused_before_anything_starts(tmp_path, text, says):
    path = tmp_path / "night.toml"
    path.write_text(text)
    with pytest.raises(MillcorrError, match=says) as raised:
        jobs.run(path, out=io.StringIO())
    assert isinstance(raised.value, FormatError | UsageError) and "night.toml" in str(raised.value)
    assert list(tmp_path.iterdir()) == [path]


def test_values_of_every_shape_reach_the_command(tmp_path):
    path = tmp_path / "night.toml"
    path.write_text(
        "[[job]]\nprogram='-a.nc'\nmeasured=['b.csv', 'c.csv']\noutput='o.nc'\ngain=0.5\n"
        "work-offset=[-1, 2.5, 3]\naccept=['unit', 'outliers']\nwork_rotation=-90\n"
        "[[job]]\nverb='convert'\nmeasured='-x.csv'\noutput='x.csv'\n"
    )
    from millcorr.cli import arguments

    first, second = (arguments.parser().parse_args(job.argv) for job in jobs.load(path))
    assert first.program == Path("-a.nc") and first.measured == [Path("b.csv"), Path("c.csv")]
    assert first.work_offset == [-1.0, 2.5, 3.0] and first.accept == ["unit", "outliers"]
    assert first.gain == 0.5 and first.work_rotation == -90
    assert second.measured == Path("-x.csv")


@pytest.mark.thorough
def test_summary_and_status_of_the_command(shop, capsys):
    path = batch(shop, JOB.format(name="out1", measured="cmm1.csv"), JOB.format(name="bad", measured="missing.csv"))
    assert main(["batch", str(path)]) == 3
    said = capsys.readouterr().out
    assert "1 of 2 jobs done" in said and "failed      bad: missing.csv" in said


@pytest.mark.thorough
def test_dask_runs_the_jobs_though_a_worker_is_killed(shop):
    distributed = pytest.importorskip("distributed", reason="optional: dask.distributed")
    path = batch(shop, *(CONVERT.format(name=f"out{n}", measured=f"cmm{n % 3 + 1}.csv") for n in range(4)))
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, scheduler_port=0
    ) as cluster:
        with distributed.Client(cluster) as client:
            victims = list(client.run(os.getpid).values())

        class Killer(io.StringIO):
            """Kills one worker when the first job is done."""

            def write(self, text):
                if text.startswith("[1/4]"):
                    os.kill(victims[0], signal.SIGKILL)
                return super().write(text)

        begun = time.monotonic()
        done = jobs.run(path, dask=cluster.scheduler_address, out=Killer())
    assert [o.status for o in done] == [0] * 4, [o.text for o in done]
    assert all((shop / f"out{n}.csv").exists() for n in range(4))
    assert time.monotonic() - begun < 300


def test_dask_without_a_scheduler_is_one_line(shop, monkeypatch):
    pytest.importorskip("distributed", reason="optional: dask.distributed")
    monkeypatch.setattr(jobs, "ANSWER_TIME", 0.5)
    with pytest.raises(UsageError, match="no scheduler answers"):
        jobs.run(three(shop), dask="tcp://127.0.0.1:1", out=io.StringIO())


SERIES = """
[[job]]
name = "{name}"
program = "{program}"
measured = "{measured}"
output = "{name}.nc"
journal = {journal}
control = "ewma:2"
control-limit = 0.004
"""


@pytest.mark.thorough
def test_jobs_with_journals(shop):
    """One beside each program, and one for all of them, which they hold one after the other."""
    for name in ("a", "b", "c"):
        (shop / f"{name}.nc").write_text(f"(PART {name})\n" + (shop / "part.nc").read_text())
    own = [SERIES.format(name=f"own{n}", program="a.nc", measured="cmm1.csv", journal="true") for n in (1,)]
    shared = [
        SERIES.format(name=f"next-{n}", program=f"{n}.nc", measured="cmm1.csv", journal='"shop.journal"') for n in "abc"
    ]
    assert [o.status for o in jobs.run(batch(shop, *own, *shared), workers=4, out=io.StringIO())] == [0] * 4
    assert [len(chain.entries) for chain in journal.read(shop / "a.nc.journal")] == [1]
    chains = journal.read(shop / "shop.journal")
    assert sorted(chain.name for chain in chains) == ["a.nc", "b.nc", "c.nc"]


@pytest.mark.thorough
def test_a_job_that_outlived_its_batch_is_done_and_entered_once(shop):
    """The batch is killed and its job goes on: the next batch finds it in the journal, before or after its end."""
    path = batch(shop, SERIES.format(name="out1", program="part.nc", measured="cmm1.csv", journal="true"))
    command = [sys.executable, "-m", "millcorr", "batch", str(path)]
    process = subprocess.Popen(command, cwd=REPOSITORY, stdout=subprocess.PIPE, start_new_session=True)
    begun = time.monotonic()
    while not (shop / "part.nc.journal").exists():
        assert time.monotonic() - begun < 60
        time.sleep(0.01)
    process.kill()
    process.communicate()
    (done,) = jobs.run(path, out=io.StringIO())
    assert done.status == 0 and not done.before
    (shop / "night.toml.state").unlink()
    (done,) = jobs.run(path, out=io.StringIO())
    assert done.status == 0 and "done before: out1.nc is in its place" in done.text
    ((entry,),) = (chain.entries for chain in journal.read(shop / "part.nc.journal"))
    assert entry.part == 1
    # Another output, or one that was changed since, is no repetition but a second use.
    output = shop / "out1.nc"
    output.write_text(output.read_text() + "\n(CHANGED)\n")
    (done,) = jobs.run(path, again=True, out=io.StringIO())
    assert done.status == 4 and "this measurement is part 1" in done.text


@pytest.mark.thorough
def test_an_interrupted_batch_ends_what_runs_and_says_what_is_done(shop):
    # So many that not all are done before the interruption arrives.
    names = [f"out{n}" for n in range(8)]
    path = batch(shop, *(CONVERT.format(name=name, measured="cmm1.csv") for name in names))
    command = [sys.executable, "-m", "millcorr", "batch", str(path), "--jobs", "1"]
    process = subprocess.Popen(
        command,
        cwd=REPOSITORY,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        # A shell that runs the tests in the background has them, and all that they start, ignore it.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    assert process.stdout.readline().startswith("[1/8] ok")
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 130
    # What ran is ended, what had not begun is left.
    done = [(shop / f"{name}.csv").exists() for name in names]
    count = sum(done)
    assert count < 8 and done == sorted(done, reverse=True)
    assert said == f"millcorr: interrupted: {count} of 8 jobs are done; run it again for the others\n"
    assert sum(o.before for o in jobs.run(path, workers=2, out=io.StringIO())) == count
