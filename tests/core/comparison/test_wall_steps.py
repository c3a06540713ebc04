# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls cut in steps: drafts and rebates, of which each pass makes the wall at its own heights.

Truth is what the discs of the written text leave at a height, found by shapely from the words alone.
"""

from __future__ import annotations

import dataclasses
import re
from pathlib import Path

import numpy as np
import pytest
import shapely

from millcorr import nc, pipeline
from millcorr.errors import InputError, LimitError
from millcorr.geometry.profile import Profile, Sections
from millcorr.production import series as serial
from millcorr.production.process_control import Control
from millcorr.readers.measurement import Measurement
from millcorr.whole_file import replaced_whole

R = 4.0
FILLET = 10.0
W, H = 80.0, 50.0
STEP, DOWN = 0.05, 2.0
TOLERANCE = 0.001
"""Of the written path; what shapely and its chords add is a tenth of it."""


def height(k: int) -> float:
    """Middle of a step of a draft."""
    return -DOWN * k - DOWN / 2


def arcs(distance: float) -> list[tuple[str, float, float]]:
    """A plate of W x H with round corners, clockwise from the middle of its lower side: words, and where they end."""
    x, y, r = W / 2 - FILLET, H / 2 - FILLET, FILLET + distance
    a, b = W / 2 + distance, H / 2 + distance
    return [
        (f"G1 X{-x:.4f} Y{-b:.4f}", -x, -b),
        (f"G2 X{-a:.4f} Y{-y:.4f} I0. J{r:.4f}", -a, -y),
        (f"G1 X{-a:.4f} Y{y:.4f}", -a, y),
        (f"G2 X{-x:.4f} Y{b:.4f} I{r:.4f} J0.", -x, b),
        (f"G1 X{x:.4f} Y{b:.4f}", x, b),
        (f"G2 X{a:.4f} Y{y:.4f} I0. J{-r:.4f}", a, y),
        (f"G1 X{a:.4f} Y{-y:.4f}", a, -y),
        (f"G2 X{x:.4f} Y{-b:.4f} I{-r:.4f} J0.", x, -b),
        (f"G1 X0. Y{-b:.4f}", 0.0, -b),
    ]


def once(distance: float, z: float) -> str:
    """One pass round the plate with straight leads."""
    b = H / 2 + distance
    words = "".join(f"{word} F400.\n" for word, _, _ in arcs(distance))
    lead = f"G0 X0. Y{-b - 15:.4f}\nG0 Z5.\nG1 Z{z:.3f} F100.\nG1 X0. Y{-b:.4f} F400.\n"
    return f"{lead}{words}G1 X0. Y{-b - 15:.4f}\nG0 Z20.\n"


def along(distance: float, z: float) -> str:
    """One pass along an open edge, 50 mm straight, 60 degrees round (0, -20), 40 mm straight; material on its right."""
    r, turn = 20.0 + distance, np.radians(30.0)
    bend = np.array([0.0, -20.0]) + r * np.array([np.cos(turn), np.sin(turn)])
    end = bend + 40.0 * np.array([np.sin(turn), -np.cos(turn)])
    away = end + 15.0 * np.array([np.cos(turn), np.sin(turn)])
    return (
        f"G0 X-50. Y{distance + 15:.4f}\nG0 Z5.\nG1 Z{z:.3f} F100.\nG1 X-50. Y{distance:.4f} F400.\nG1 X0.\n"
        f"G2 X{bend[0]:.4f} Y{bend[1]:.4f} I0. J{-r:.4f}\nG1 X{end[0]:.4f} Y{end[1]:.4f}\n"
        f"G1 X{away[0]:.4f} Y{away[1]:.4f}\nG0 Z20.\n"
    )


def edge(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Evenly spread places of the open edge and their normals, none within 4 mm of its ends."""
    s = np.linspace(4.0, 50.0 + 20.0 * np.pi / 3 + 40.0 - 4.0, count)
    angle = np.pi / 2 - np.clip((s - 50.0) / 20.0, 0.0, np.pi / 3)
    normal = np.column_stack([np.cos(angle), np.sin(angle)])
    ahead = np.column_stack([normal[:, 1], -normal[:, 0]])
    straight = np.where(s < 50.0, s - 50.0, np.maximum(s - 50.0 - 20.0 * np.pi / 3, 0.0))
    return np.array([0.0, -20.0]) + 20.0 * normal + straight[:, None] * ahead, normal


def program(*passes: str) -> str:
    return "%\nO1\nG21 G90 G17\n" + "".join(passes) + "M30\n%\n"


def plate(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Evenly spread places of the plate's wall, none at the lead, and their normals."""
    x, y = W / 2 - FILLET, H / 2 - FILLET
    core = shapely.Polygon([(-x, -y), (-x, y), (x, y), (x, -y)])
    ring = core.buffer(FILLET, quad_segs=2000).exterior
    s = (np.arange(count) + 0.5) / count * ring.length
    at = shapely.get_coordinates(shapely.line_interpolate_point(ring, s))
    foot = shapely.get_coordinates(shapely.shortest_line(core, shapely.points(at)))[::2]
    at = at[np.hypot(at[:, 0], at[:, 1] + H / 2) > 8.0]
    foot = np.clip(at, [-x, -y], [x, y])
    normal = (at - foot) / np.hypot(*(at - foot).T)[:, None]
    return foot + FILLET * normal, normal


def form(at: np.ndarray) -> np.ndarray:
    """What repeats at places of the plate, two waves round it, mm."""
    return 0.012 * np.cos(2 * np.arctan2(at[:, 1], at[:, 0]))


def measured(*groups: np.ndarray, has_z: bool = True) -> Measurement:
    xyz = np.concatenate(groups)
    return Measurement(xyz, None, 0.0, np.arange(1, len(xyz) + 1), "part.csv", "cd" * 32, has_z)


def points(at: np.ndarray, normal: np.ndarray, over: np.ndarray | float, z: float, noise: float = 0.0, seed: int = 0):
    """Contact points so many mm over places, with white noise."""
    rng = np.random.default_rng(seed)
    off = over + noise * rng.standard_normal(len(at))
    return np.column_stack([at + np.reshape(off, (-1, 1)) * normal, np.full(len(at), z)])


def correct(text: str, part: Measurement, **settings) -> tuple[pipeline.Result, str]:
    request = pipeline.Request(nc.parse(text, "part.nc"), R, part, settings=pipeline.Settings(**settings))
    result = pipeline.correct(request)
    return result, "\n".join(line for line in result.text.decode().splitlines() if not line.startswith("("))


def left(text: str, z: float) -> shapely.Geometry:
    """What the discs of all cuts that go down to z take away; arcs in chords of a tenth of a micrometre."""
    at, deep, mode, cuts = np.full(2, np.nan), 5.0, 0, []
    for line in text.splitlines():
        words = dict(re.findall(r"([GXYZIJ])(-?[\d.]+)", re.sub(r"\(.*?\)", "", line)))
        mode = int(float(words.get("G", mode)))
        new = np.array([float(words.get("X", at[0])), float(words.get("Y", at[1]))])
        deep = float(words.get("Z", deep))
        if mode in (1, 2, 3) and deep <= z and np.isfinite([*at, *new]).all():
            path = [at, new]
            if mode > 1 and ("I" in words or "J" in words):
                centre = at + [float(words.get("I", 0.0)), float(words.get("J", 0.0))]
                a0, a1 = (np.arctan2(*(p - centre)[::-1]) for p in path)
                turn = (a1 - a0) % (2 * np.pi) if mode == 3 else -((a0 - a1) % (2 * np.pi))
                r = np.linspace(*(np.hypot(*(p - centre)) for p in path), 801)
                angle = a0 + np.linspace(0.0, turn, 801)
                path = centre + r[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
            cuts.append(shapely.LineString(path) if (at != new).any() else shapely.Point(at))
        at = new
    return shapely.union_all([cut.buffer(R, quad_segs=512) for cut in cuts])


def off(text: str, z: float, wanted: np.ndarray) -> np.ndarray:
    """Distance of places from the wall that the text leaves at a height, mm."""
    return shapely.distance(shapely.points(wanted), left(text, z).boundary)


def draft(*numbers: int, step: float = STEP) -> list[str]:
    """Passes of some steps of a draft round the plate, each deeper one farther out."""
    return [once(R + step * k, -DOWN * (k + 1)) for k in numbers]


def deviating(over: dict[int, float], count: int, noise: float = 0.0003, step: float = STEP) -> Measurement:
    """Points of steps of the draft that are so much too large beside the form, mm."""
    at, normal = plate(count)
    rows = [points(at + step * k * normal, normal, form(at) + d, height(k), noise, k) for k, d in over.items()]
    return measured(*rows)


def assert_right(text: str, over: dict[int, float], allowed: float, step: float = STEP) -> None:
    """The next part's steps are right: what was too much is gone, within so many mm."""
    at, normal = plate(97)
    for k, d in over.items():
        wanted = at + (step * k - form(at) - d)[:, None] * normal
        assert off(text, height(k), wanted).max() < allowed, k


ESTIMATED = 0.0009
"""Three standard deviations of a single point: a form that many points share is known better."""


def test_five_steps_of_a_draft_in_one_run() -> None:
    """Each by what it deviates itself, with arcs, some twenty points a step for a form of two waves."""
    over = dict(enumerate([0.015, 0.010, 0.020, -0.005, 0.012]))
    result, new = correct(program(*draft(*range(5))), deviating(over, 25))
    assert_right(new, over, TOLERANCE + ESTIMATED)
    assert not result.warnings
    # What a step has by itself is told by twenty points, each of them good to 0.3 um.
    assert result.uncertainty.max() < 0.0003
    assert [c.step.bottom for c in result.nominal.contours if c.step] == [-10.0, -8.0, -6.0, -4.0, -2.0]
    assert len(re.findall("G2 ", new)) >= 20


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_an_open_wall_in_steps(sign: float) -> None:
    """The leads stand at right angles to it: a wall that comes out ends where it meets theirs."""
    over = {0: sign * 0.015, 1: sign * 0.011, 2: sign * 0.020}
    at, normal = edge(30)

    def wave(at: np.ndarray) -> np.ndarray:
        return 0.008 * np.sin(at[:, 0] / 10.0)

    rows = [points(at + STEP * k * normal, normal, wave(at) + d, height(k), 0.0003, k) for k, d in over.items()]
    text = program(*[along(R + STEP * k, -DOWN * (k + 1)) for k in over])
    _, new = correct(text, measured(*rows))
    at, normal = edge(90)
    for k, d in over.items():
        wanted = at + (STEP * k - wave(at) - d)[:, None] * normal
        assert off(new, height(k), wanted).max() < TOLERANCE + ESTIMATED, k


def test_roughing_in_the_same_program_stays() -> None:
    over = {0: 0.015, 1: 0.004, 2: 0.020}
    rough = [once(R + STEP * k + stock, -DOWN * (k + 1)) for stock in (0.5, 0.12) for k in over]
    _, new = correct(program(*rough, *draft(*over)), deviating(over, 25))
    for one in rough:
        assert one in new
    assert_right(new, over, TOLERANCE + ESTIMATED)


def test_steps_between_measured_ones_go_along_and_those_beyond_stay() -> None:
    passes = draft(*range(6))
    result, new = correct(program(*passes), deviating({1: 0.020, 4: 0.008}, 25))
    # Between two steps a third has what lies between by height: 20, 16, 12, 8 um.
    assert_right(new, {1: 0.020, 2: 0.016, 3: 0.012, 4: 0.008}, TOLERANCE + ESTIMATED)
    assert passes[0] in new and passes[5] in new
    assert [w for w in result.warnings if "without measured points, down to Z-2.000, Z-12.000: left as they are" in w]


def test_points_without_a_height_are_refused_and_what_would_tell_is_said() -> None:
    part = deviating({0: 0.01, 1: 0.01}, 27)
    flat = Measurement(part.points * [1, 1, 0], None, 0.0, part.lines, part.source, part.digest, has_z=False)
    with pytest.raises(InputError, match=r"in steps down to Z-2, Z-4.*no height.*third coordinate"):
        correct(program(*draft(0, 1)), flat)


def test_a_program_in_steps_is_corrected_again() -> None:
    """What the first correction left goes with the second; the first program says what the steps are."""
    over, more = {0: 0.015, 1: -0.004, 2: 0.020}, {0: 0.002, 1: 0.001, 2: -0.001}
    first = nc.parse(program(*draft(*over)), "first.nc")
    one = deviating(over, 25)
    at, normal = plate(25)
    rows = [points(at + STEP * k * normal, normal, d, height(k), 0.0003, 9 + k) for k, d in more.items()]
    xyz = np.concatenate(rows)
    two = Measurement(xyz, None, 0.0, np.arange(1, len(xyz) + 1), "second.csv", "ef" * 32)
    text = pipeline.correct(pipeline.Request(first, R, one)).text
    nominal = pipeline.nominal_from_program(first, R, pipeline.Settings(), two)
    request = pipeline.Request(nc.parse(text, "second.nc"), R, two, nominal, nominal_is_first_program=True)
    new = pipeline.correct(request).text.decode()
    total = {k: over[k] + more[k] for k in over}
    assert_right(new, total, 2 * (TOLERANCE + ESTIMATED))


def test_a_draft_is_a_series(tmp_path: Path) -> None:
    """Two parts of one program: the first one within the limit, both together beyond it; each step by their mean."""
    first, over = nc.parse(program(*draft(*range(3))), "P0.nc"), {0: 0.015, 1: 0.011, 2: 0.020}
    more = {k: d + 0.010 for k, d in over.items()}
    control, out = Control(2, 0.034), tmp_path / "P1.nc"
    at, normal = plate(25)
    for number, now in enumerate((over, more)):
        rows = [
            points(at + STEP * k * normal, normal, form(at) + d, height(k), 0.0003, 3 * number + k)
            for k, d in now.items()
        ]
        part = dataclasses.replace(measured(*rows), source=f"{number}.csv", digest=f"{number:02d}" * 32)
        request = pipeline.Request(first, R, part)
        with (
            serial.corrected(request, out, tmp_path / "P0.journal", control) as outcome,
            replaced_whole(out, outcome.result.text),
        ):
            pass
        assert outcome.decision is not None and outcome.decision.kind == ("keep", "smoothed")[number]
    text = "\n".join(line for line in out.read_text().splitlines() if not line.startswith("("))
    # Of two parts the later one counts twice.
    assert_right(text, {k: (over[k] + 2 * more[k]) / 3 for k in over}, TOLERANCE + ESTIMATED)


def test_a_rebate_is_another_wall() -> None:
    """Two walls farther apart than a point can be off: each has its own form, here the opposite ones."""
    wide, at, normal = 5.0, *plate(60)
    rows = [
        points(at, normal, form(at) + 0.010, -1.0, 0.0003, 1),
        points(at + wide * normal, normal, 0.006 - form(at), -4.0, 0.0003, 2),
    ]
    result, new = correct(program(once(R, -2.0), once(R + wide, -6.0)), measured(*rows))
    # The cutter that makes the upper one stands over the lower one: this is a wall below it only.
    assert [c.step and (c.step.bottom, c.step.top) for c in result.nominal.contours] == [(-6.0, -2.0), (-2.0, np.inf)]
    assert result.nominal.steps == ((0,), (1,))
    at, normal = plate(97)
    for z, wanted in ((-1.0, -form(at) - 0.010), (-4.0, wide + form(at) - 0.006)):
        assert off(new, z, at + wanted[:, None] * normal).max() < TOLERANCE + ESTIMATED, z


def sided(k: int) -> str:
    """A pass round a plate that is drafted on its right side only."""
    x, y, e = W / 2 + R, H / 2 + R, STEP * k
    words = "".join(f"G1 X{a:.3f} Y{b:.3f}\n" for a, b in [(-x, -y), (-x, y), (x + e, y), (x + e, -y), (0.0, -y)])
    lead = f"G0 X0. Y{-y - 15:.3f}\nG0 Z5.\nG1 Z{-DOWN * (k + 1):.3f} F400.\nG1 X0. Y{-y:.3f}\n"
    return f"{lead}{words}G1 X0. Y{-y - 15:.3f}\nG0 Z20.\n"


def extent(text: str, z: float) -> np.ndarray:
    """Where the walls of a rectangle stand at a height: left, bottom, right, top, mm over W x H."""
    inside = shapely.box(-W / 2 - 1, -H / 2 - 1, W / 2 + 1, H / 2 + 1).difference(left(text, z))
    x0, y0, x1, y1 = max(getattr(inside, "geoms", [inside]), key=lambda one: one.area).bounds
    return np.array([-x0 - W / 2, -y0 - H / 2, x1 - W / 2, y1 - H / 2])


def test_where_a_part_is_drafted_on_one_side_only_the_others_are_one_wall() -> None:
    """A pass cuts at all heights above its own: sides that the steps share get one correction, their mean."""
    over = {0: 0.005, 1: 0.010, 2: 0.024}
    rows = []
    for k, d in over.items():
        s, x, y = np.linspace(-15.0, 15.0, 8), W / 2 + d, H / 2 + d
        sides = [(-x, s), (x + STEP * k, s), (s + 20.0, y), (s - 20.0, -y)]
        xy = [np.column_stack(np.broadcast_arrays(a, b)) for a, b in sides]
        rows.append(np.column_stack([np.concatenate(xy), np.full(32, height(k))]))
    _, new = correct(program(*map(sided, over)), measured(*rows))
    for k, d in over.items():
        shared = -np.mean(list(over.values()))
        np.testing.assert_allclose(extent(new, height(k)), [shared, shared, STEP * k - d, shared], atol=TOLERANCE)


def test_steps_nearer_to_each_other_than_they_deviate_stay_in_order() -> None:
    """Steps of 4 um: the nearest wall in order is half way where one should stand 10 um over the one below."""
    over = {0: 0.004, 1: 0.018}
    result, new = correct(program(*draft(0, 1, step=0.004)), deviating(over, 25, step=0.004))
    at, normal = plate(97)
    # 0 - 4 and 4 - 18 um are out of order; -9 um is the mean.
    for k in over:
        assert off(new, height(k), at + (-0.009 - form(at))[:, None] * normal).max() < TOLERANCE + ESTIMATED, k
    assert result.verification.gouge_max < TOLERANCE


def test_a_wider_pass_that_stays_and_would_cut_into_a_step_is_named() -> None:
    """The step is to come out by 0.08 mm, and the next one below, 0.05 mm farther out, has no points."""
    with pytest.raises(LimitError, match=r"line \d+ of the corrected program, which is not corrected itself"):
        correct(program(*draft(0, 1)), deviating({0: -0.08}, 40))


def test_sections() -> None:
    over = {0: 0.0, 1: 0.0, 2: 0.0}
    result, _ = correct(program(*draft(*over)), deviating(over, 20))
    profile = Profile.from_dict(result.nominal.as_dict())
    sections = profile.sections
    assert profile.steps == ((0, 1, 2),)
    np.testing.assert_array_equal(sections.bounds, [-4.0, -2.0])
    # A pass makes the wall from its own height up; below the lowest the wall goes on as that.
    heights = np.array([-9.0, -6.0, -4.1, -4.0, -2.1, -2.0, 3.0, np.nan])
    np.testing.assert_array_equal(sections.at(heights), [0, 0, 0, 1, 1, 2, 2, -1])
    assert [c.tolist() for c in sections.contours] == [[0], [1], [2]]
    # A step alone is the wall at all heights.
    assert Sections.of(profile.part(np.array([1])).contours).bounds.size == 0
