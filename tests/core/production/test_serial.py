# SPDX-License-Identifier: LGPL-2.1-or-later
"""A series of parts through the whole loop: the sequence of the requirement, chains of programs, refusals."""

from __future__ import annotations

import dataclasses
import hashlib
import re
from pathlib import Path

import numpy as np
import pytest

from millcorr import nc, pipeline
from millcorr.correction import provenance
from millcorr.errors import InputError, LimitError, RefusedError, UsageError
from millcorr.production import history, journal
from millcorr.production import series as serial
from millcorr.production.process_control import LIMITS, Control
from millcorr.virtual.simulated_machine import ErrorField, SimulatedMachine
from millcorr.whole_file import replaced_whole
from tests.core import loop_programs as programs

UM = 1e-3
ROUNDING = 1e-3
"""Path tolerance: what the written program's decimals may add."""


class Shop:
    """One directory, one part: P0 and what is made of it; parts are measured as told."""

    def __init__(self, directory: Path, control: Control | None = None, **settings) -> None:
        self.directory, self.control = directory, control
        self.settings = pipeline.Settings(**({"side": "right", "filter": "none"} | settings))
        self.journal = directory / "P0.nc.journal"
        self.first = nc.parse(programs.RECTANGLE, "P0.nc")
        self.nominal = pipeline.nominal_from_program(self.first, programs.RADIUS, self.settings, None)
        self.programs = [self.first]
        self.count = 0

    def measure(self, deviation, number: int | None = None, **options):
        """A part with a deviation: a number in um, or a function of contour and arc length in mm."""
        self.count += 1
        number = self.count if number is None else number
        if not callable(deviation):
            size = deviation * UM

            def deviation(k, s):
                return np.full(len(s), size)

        # Heights differ a little, so that equal deviations are different measurements.
        made = programs.measured(self.nominal, deviation, z=-3 - 1e-3 * number, **options)
        return dataclasses.replace(made, source=f"part-{number}.csv")

    def next(self, measurement, program=None, **changed):
        """Give the part's program and its measurement to the series; the outcome and the next program."""
        program = program or self.programs[-1]
        settings = dataclasses.replace(self.settings, **changed)
        request = pipeline.Request(program, programs.RADIUS, measurement, self.nominal, settings)
        output = self.directory / f"P{len(self.programs)}.nc"
        with serial.corrected(request, output, self.journal, self.control) as outcome:
            with replaced_whole(output, outcome.result.text):
                pass
        self.programs.append(nc.read(output))
        return outcome

    @property
    def entries(self):
        (chain,) = journal.read(self.journal)
        return chain.entries


def test_first_part_then_the_sequence_of_the_requirement(tmp_path: Path) -> None:
    """Part 1 shows 20 um and is corrected in full; then the published parts, each cut with the program before."""
    shop = Shop(tmp_path, Control(2, 4 * UM))
    outcomes = [shop.next(shop.measure(size)) for size in (20, 3, 5, 6, 2, 4, 5, 5, 3, 7, 7)]
    assert [o.decision.kind for o in outcomes] == ["direct"] + ["keep", "keep", "smoothed"] + ["keep"] * 3 + [
        "smoothed",
        "keep",
        "smoothed",
        "keep",
    ]
    smoothed = [float(np.abs(o.decision.smoothed).max()) / UM for o in outcomes[1:]]
    assert smoothed == pytest.approx([1.5, 3.25, 4.625, 1, 2.5, 3.75, 4.375, 1.5, 4.25, 3.5], abs=1e-3)
    assert [o.part for o in outcomes] == list(range(1, 12))
    # The sum of the corrections, each read from the program that was written.
    sums = [20, 20, 20, 24.625, 24.625, 24.625, 24.625, 29, 29, 33.25, 33.25]
    for outcome, total in zip(outcomes, sums, strict=True):
        assert outcome.result.correction.largest == pytest.approx(total * UM, abs=ROUNDING)
        assert outcome.result.verification.path_error_max <= ROUNDING
    last = pipeline.correct(
        pipeline.Request(shop.programs[-1], programs.RADIUS, shop.measure(0), shop.nominal, shop.settings)
    )
    assert last.commanded == pytest.approx(np.full(len(last.commanded), -33.25 * UM), abs=ROUNDING)
    assert [float(e.state[0]) / UM for e in shop.entries] == pytest.approx(
        [0, 1.5, 3.25, 0, 1, 2.5, 3.75, 0, 1.5, 0, 3.5], abs=1e-6
    )


def test_without_a_correction_the_very_bytes_go_on_and_everything_says_so(tmp_path: Path) -> None:
    shop = Shop(tmp_path, Control(2, 4 * UM))
    shop.next(shop.measure(20))
    outcome = shop.next(shop.measure(3))
    assert not outcome.corrected
    assert (tmp_path / "P2.nc").read_bytes() == (tmp_path / "P1.nc").read_bytes()
    (note,) = outcome.notes
    assert note.startswith("NOT CORRECTED: the smoothed deviation, 1.50 um at most, is within the limit of 4.00 um")
    assert note.endswith("the output is the very bytes of P1.nc")
    summary = outcome.result.summary()
    assert note in summary["advice"]
    assert summary["moves"]["changed"] == 0
    assert summary["predicted"]["mean"] == pytest.approx(summary["deviation"]["mean"])
    assert not shop.entries[1].corrected
    assert "NOT CORRECTED" in history.table(journal.read(shop.journal)).splitlines()[3]


def test_a_first_part_within_the_limit_leaves_the_first_program(tmp_path: Path) -> None:
    shop = Shop(tmp_path, Control(2, 4 * UM))
    outcome = shop.next(shop.measure(3.5))
    assert not outcome.corrected and outcome.result.text == shop.first.data
    assert outcome.result.correction.largest == 0
    # Still uncorrected: z does not begin at 0 but is the weighted mean of both, and the journal goes on.
    second = shop.next(shop.measure(4.5))
    assert second.decision.kind == "smoothed" and second.part == 2
    mean = (4.5 + 3.5 / 2) / 1.5
    assert float(np.abs(second.decision.smoothed).max()) / UM == pytest.approx(mean, abs=1e-6)
    assert second.result.correction.largest == pytest.approx(mean * UM, abs=ROUNDING)


def test_without_control_the_journal_records_plain_corrections(tmp_path: Path) -> None:
    shop = Shop(tmp_path)
    measurement = shop.measure(20)
    outcome = shop.next(measurement)
    plain = pipeline.correct(pipeline.Request(shop.first, programs.RADIUS, measurement, shop.nominal, shop.settings))
    assert outcome.result.text == plain.text and outcome.decision is None and outcome.notes == ()
    (entry,) = shop.entries
    assert entry.decision == "correct" and entry.corrected
    assert entry.before == ("P0.nc", shop.first.digest)
    assert entry.after == ("P1.nc", hashlib.sha256(plain.text).hexdigest())
    assert entry.measurements == (("part-1.csv", measurement.fingerprint),)
    assert entry.correction == pytest.approx(-20 * UM) and entry.deviation == pytest.approx(20 * UM)


def test_form_along_the_contour_is_smoothed_place_by_place(tmp_path: Path) -> None:
    """Two parts with waves of different size, measured at different places; the correction is their average."""
    shop = Shop(tmp_path, Control(2, 4 * UM))
    shop.next(shop.measure(20))
    total = float(shop.nominal.total[0])

    def wave(size):
        # Whole waves between the corners at 0, 100, 150 and 250 mm.
        return lambda k, s: size * UM * np.cos(2 * np.pi * s / 25)

    assert total == pytest.approx(300)
    assert shop.next(shop.measure(wave(7))).decision.kind == "keep"
    outcome = shop.next(shop.measure(wave(5), spacing=0.8))
    assert outcome.decision.kind == "smoothed"
    d = outcome.result.deviation
    change = outcome.result.predicted - d.value
    expected = -(7 / 4 + 5 / 2) * UM * np.cos(2 * np.pi * d.s / 25)
    # Splines run out level at the corners, where a cosine is level too; places are 0.5 mm apart.
    assert change == pytest.approx(expected, abs=0.1 * UM)


def test_the_same_measurement_twice_is_refused(tmp_path: Path) -> None:
    shop = Shop(tmp_path, Control(2, 4 * UM))
    shop.next(shop.measure(20))
    kept = shop.measure(3)
    shop.next(kept)
    data = (tmp_path / "P0.nc.journal").read_bytes()
    # The program carries no mark of it; the journal knows.
    assert kept.fingerprint[:16] not in {
        m for mark in provenance.marks(shop.programs[-1].comments()) for m in mark.measured
    }
    with pytest.raises(RefusedError, match=r"part-2\.csv: this measurement is part 2 of .*P0\.nc\.journal already"):
        shop.next(dataclasses.replace(kept, points=kept.points[::-1].copy()))
    assert (tmp_path / "P0.nc.journal").read_bytes() == data and not (tmp_path / "P3.nc").exists()


def test_a_part_of_an_earlier_program_is_refused(tmp_path: Path) -> None:
    """Two parts were cut with P0; the second one's error is corrected already by the first's."""
    shop = Shop(tmp_path)
    shop.next(shop.measure(20))
    with pytest.raises(InputError, match=r"P0\.nc: .* goes on from P1\.nc; since P0\.nc it was corrected by part 1"):
        shop.next(shop.measure(21), program=shop.first)
    shop.next(shop.measure(1))
    with pytest.raises(InputError, match=r"P1\.nc: .* goes on from P2\.nc; .* corrected by part 2"):
        shop.next(shop.measure(1), program=shop.programs[1])
    assert len(shop.entries) == 2


def test_a_program_corrected_elsewhere_is_refused(tmp_path: Path) -> None:
    shop = Shop(tmp_path)
    shop.next(shop.measure(20))
    request = pipeline.Request(shop.programs[-1], programs.RADIUS, shop.measure(2), shop.nominal, shop.settings)
    elsewhere = nc.parse(pipeline.correct(request).text, "elsewhere.nc")
    with pytest.raises(InputError, match=r"elsewhere\.nc: it carries a correction .* does not know.*--journal OTHER"):
        shop.next(shop.measure(1), program=elsewhere)
    # A new journal begins with what the program carries.
    shop.journal = tmp_path / "other.journal"
    assert shop.next(shop.measure(1), program=elsewhere).part == 1
    assert len(journal.read(shop.journal)[0].carried) == 2


def test_other_comments_and_feeds_in_the_program_do_not_matter(tmp_path: Path) -> None:
    shop = Shop(tmp_path, Control(2, 4 * UM))
    shop.next(shop.measure(20))
    edited = nc.parse(shop.programs[-1].data.replace(b"F300", b"F280"), "P1.nc")
    assert shop.next(shop.measure(3), program=edited).part == 2


def test_another_nominal_is_refused(tmp_path: Path) -> None:
    shop = Shop(tmp_path)
    shop.next(shop.measure(20))
    scaled = programs.RECTANGLE.replace("X105", "X105.02").replace("G1 X105.02", "G1 X105.02", 1)
    shop.nominal = pipeline.nominal_from_program(nc.parse(scaled), programs.RADIUS, shop.settings, None)
    with pytest.raises(InputError, match="the nominal has other contours or lengths"):
        shop.next(shop.measure(1))


def test_limits_of_a_step_and_of_the_sum(tmp_path: Path) -> None:
    shop = Shop(tmp_path, Control(2, 4 * UM, step_limit=25 * UM, sum_limit=30 * UM))
    with pytest.raises(LimitError, match="26.00 um, more than --step-limit 0.025"):
        shop.next(shop.measure(26))
    assert not shop.journal.exists() or journal.read(shop.journal) == ()
    shop.next(shop.measure(24))
    assert shop.next(shop.measure(7)).decision.kind == "keep"
    with pytest.raises(LimitError, match="more than --sum-limit 0.03"):
        shop.next(shop.measure(10))
    assert len(shop.entries) == 2
    # Without the limit on the sum the same part is corrected: 7/4 + 10/2.
    shop.control = Control(2, 4 * UM, step_limit=25 * UM)
    assert shop.next(shop.measure(10.01)).result.correction.largest == pytest.approx(30.755 * UM, abs=ROUNDING)


def test_tolerance_and_alarm(tmp_path: Path) -> None:
    shop = Shop(tmp_path, Control(4, 4 * UM, tolerance=10 * UM, alarm=30 * UM))
    shop.next(shop.measure(20))
    assert shop.next(shop.measure(9)).decision.kind == "keep"
    outcome = shop.next(shop.measure(12))
    assert outcome.decision.kind == "direct"
    assert outcome.result.correction.largest == pytest.approx(32 * UM, abs=ROUNDING)
    jumped = shop.measure(40)
    with pytest.raises(LimitError, match="--accept difference"):
        shop.next(jumped)
    assert len(shop.entries) == 3
    assert shop.next(jumped, accept=("difference",)).decision.kind == "direct"


@pytest.mark.thorough
def test_wear_shows_as_a_trend_whatever_is_corrected(tmp_path: Path) -> None:
    """1.5 um a part: corrections keep the parts good and hide the wear in them, not in what the machine does."""
    shop = Shop(tmp_path, Control(1, 2 * UM))
    in_force = 0.0
    for number in range(9):
        wear = 12 + 1.5 * number
        outcome = shop.next(shop.measure(wear - in_force + 0.05 * (-1) ** number))
        if outcome.corrected:
            in_force = outcome.result.correction.largest / UM
    (line,) = [w for w in outcome.result.warnings if "drift" in w]
    assert re.search(r"drift of the mean by \+1\.(49|5\d) um a part from part 2 to 9 .* tool wear or warming", line)
    assert line in history.table(journal.read(shop.journal))


def elastic_series(directory: Path, seed: int, new_tool: float = 0.0) -> list[str]:
    """What a series of 14 parts of an elastic machine shows; a new tool of so many um before part 10.

    MS 0.12 leaves 32 um of 0.3 mm. With gain 0.6 it takes four corrections, of which a share of 0.12 / 1.12 comes
    back, 2.1 um of the first, 1.0 um of the second, while the mean of a part scatters by 0.2 um: each of them is a
    jump to who takes the machine for a rigid one.
    """
    shop = Shop(directory, Control(1, 2 * UM), gain=0.6, filter="auto")
    random = np.random.default_rng(seed)
    for number in range(1, 15):
        size = random.normal(0.0, 0.2) + (new_tool if number >= 10 else 0.0)
        machine = SimulatedMachine(
            ErrorField(constant=size * UM, directional=((2, 3 * UM, 0.4),)),
            allowance=0.3,
            transfer=0.12,
            measurement_noise=0.5 * UM,
        )
        part = machine.cut(shop.programs[-1].toolpath, programs.RADIUS, shop.nominal, seed=seed)
        points = part.measure(200, z=-3.0, seed=100 * seed + number)
        shop.next(dataclasses.replace(points, source=f"part-{number}.csv"))
    assert sum(e.corrected for e in shop.entries) >= 4
    return [line for line, _ in history.series(shop.entries)]


@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(2))
def test_what_an_elastic_machine_gives_back_is_no_jump(tmp_path: Path, seed: int) -> None:
    assert elastic_series(tmp_path, seed) == []


@pytest.mark.thorough
def test_a_new_tool_on_an_elastic_machine_is_the_only_jump(tmp_path: Path) -> None:
    (line,) = elastic_series(tmp_path, 1, -12.0)
    found = re.match(r"jump of the mean by (-1[\d.]+) um before part 10 .* a new tool", line)
    # The return of corrections before and after is in it: 0.11 of 12 um at most.
    assert found and float(found[1]) == pytest.approx(-12.0, abs=1.5)


@pytest.mark.few(1)
@pytest.mark.parametrize(("method", "back"), [("transfer", 0.0), ("mirror", 0.12 / 1.12)])
def test_the_transfer_function_under_control(tmp_path: Path, method: str, back: float) -> None:
    """MS 0.12 and depth 0.3 mm; then 6 and 7 um more excess of which K = 2 smooths to 6/4 + 7/2 = 5 um.

    What is smoothed is taken out as an elastic machine needs it, (1 + MS)-fold; mirrored, the share b of it stays.
    """
    depth = {"depth": 0.3} if method == "transfer" else {}
    shop = Shop(tmp_path, Control(2, 4 * UM), method=method, tolerance=0.1 * UM, **depth)

    def cut(excess):
        machine = SimulatedMachine(ErrorField(constant=excess * UM), allowance=0.3, transfer=0.12)
        part = machine.cut(shop.programs[-1].toolpath, programs.RADIUS, shop.nominal, seed=1)
        points = part.measure(150, z=-3.0 - 1e-3 * len(shop.programs), seed=len(shop.programs))
        return shop.next(dataclasses.replace(points, source=f"part-{len(shop.programs)}.csv"))

    first = cut(0.0)
    left = 300 * 0.12 / 1.12
    assert first.decision.kind == "direct" and first.result.deviation.value.mean() / UM == pytest.approx(left, abs=0.01)
    stays = back * left
    assert cut(6.0 - stays).result.deviation.value.mean() / UM == pytest.approx(6.0, abs=0.1)
    second = cut(7.0 - stays)
    smoothed = float(np.abs(second.decision.smoothed).max())
    assert second.decision.kind == "smoothed" and smoothed / UM == pytest.approx(5.0, abs=0.1)
    seen = second.result.deviation.value.mean()
    third = cut(7.0 - stays)
    gone = seen - third.result.deviation.value.mean()
    # One depth takes the further excess for elastic, too. Two programs with a tolerance of 0.1 um are compared.
    elastic = second.result.elastic
    gain = 1.0 if elastic is None else float(1.0 + elastic.transfer.ms.mean())
    assert gone / smoothed == pytest.approx(gain / 1.12, abs=0.2 / 5)
    assert (elastic is None) == (method == "mirror") and gain < 1.15


def test_control_refuses_what_is_no_series(tmp_path: Path) -> None:
    shop = Shop(tmp_path, Control(2, 4 * UM))
    for changed, said in (
        ({"method": "transfer", "depth": 0.3, "next_depth": 0.5}, "cut alike"),
        ({"method": "transfer", "depth": 0.3, "allowance": 0.2}, "does not go with --allowance"),
        ({"method": "combined"}, "not with --method combined"),
    ):
        with pytest.raises(UsageError, match=said):
            shop.next(shop.measure(20), **changed)
    assert not shop.journal.exists()
    assert shop.next(shop.measure(20), method="transfer", depth=0.3, next_depth=0.3).part == 1


@pytest.mark.thorough
def test_a_displaced_part_shows_as_a_jump_of_the_place(tmp_path: Path) -> None:
    shop = Shop(tmp_path, Control(4, 40 * UM))
    x = np.array([1.0, 0.0])

    def displaced(size):
        def deviation(k, s):
            _, normal = shop.nominal.at(k, s)
            return 5 * UM + size * UM * normal @ x

        return deviation

    for number in range(7):
        shop.next(shop.measure(displaced(0.1 * (-1) ** number)))
    outcome = shop.next(shop.measure(displaced(25)))
    (line,) = [w for w in outcome.result.warnings if "jump" in w]
    # 25 um less what a spline through the points makes of it, which differs with the version of scipy.
    jump = float(line.partition("jump of the place X by ")[2].split()[0])
    assert abs(jump - 25.0) < 0.5 and "before part 8" in line and "measure another" in line
    outcome = shop.next(shop.measure(displaced(25.1)))
    (line,) = [w for w in outcome.result.warnings if "jump" in w]
    assert "a chip at the stop" in line and "measure another" not in line


def test_a_side_that_the_last_part_lacks_is_told_by_the_others(tmp_path: Path) -> None:
    shop = Shop(tmp_path, Control(2, 4 * UM))
    shop.next(shop.measure(20))
    shop.next(shop.measure(4))
    whole = shop.measure(4)
    part = whole.points[:, 1] < 49.9
    partial = dataclasses.replace(whole, points=whole.points[part], lines=whole.lines[part])
    state = shop.next(partial).decision.smoothed / UM
    assert state == pytest.approx(3.0, abs=1e-6)


def test_what_goes_wrong_while_writing_leaves_no_entry(tmp_path: Path) -> None:
    shop = Shop(tmp_path)
    request = pipeline.Request(shop.first, programs.RADIUS, shop.measure(20), shop.nominal, shop.settings)
    output = tmp_path / "P1.nc"
    with pytest.raises(OSError, match="disk full"):
        with serial.corrected(request, output, shop.journal) as outcome, replaced_whole(output, outcome.result.text):
            raise OSError("disk full")
    assert not output.exists() and journal.read(shop.journal) == ()
    assert shop.next(shop.measure(20, number=1)).part == 1


def test_options(tmp_path: Path) -> None:
    nothing = dict.fromkeys(LIMITS)
    assert serial.control_from(None, 0.0, journal=True, **nothing) is None
    given = nothing | {"control_limit": 0.004, "step_limit": 0.02}
    chosen = serial.control_from("ewma:3", 0.001, journal=True, **given)
    assert (chosen.weight, chosen.limit, chosen.dead_band, chosen.step_limit) == (3, 0.004, 0.001, 0.02)
    for kind, with_journal, given, said in (
        ("ewma:3", False, {"control_limit": 0.004}, "--control needs --journal"),
        ("ewma:3", True, {}, "--control needs --control-limit"),
        (None, True, {"control_limit": 0.004}, "--control-limit belongs to --control"),
        (None, True, {"sum_limit": 0.004}, "--sum-limit belongs to --control"),
    ):
        with pytest.raises(UsageError, match=said):
            serial.control_from(kind, 0.0, journal=with_journal, **(nothing | given))
    assert serial.default_journal(Path("a/P1.nc"), "b/P0.nc") == Path("b/P0.nc.journal")
    assert serial.default_journal(Path("a/P0.nc"), None) == Path("a/P0.nc.journal")
    assert serial.default_journal(Path("P1.nc"), "JOB.FCStd#Part") == Path("JOB.FCStd.journal")
