# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings over many simulated parts: none on sound ones, always the right one on spoilt ones."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from millcorr import nc, pipeline, plausibility
from millcorr.comparison.ball_radius import axis_residue, contact_known
from millcorr.comparison.deviation import Deviation, deviations
from millcorr.correction.wanted_displacement import Part, correction_through, wanted_displacement
from millcorr.errors import DistrustError
from millcorr.geometry.correction import Correction
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.plausibility.findings import NAMES, Finding
from millcorr.readers.measurement import Measurement
from millcorr.virtual.simulated_machine import ErrorField, SimulatedMachine, SimulatedPart, reference_contour
from tests.core.stages.test_pipeline import PROGRAM, nominal_of
from tests.core.sweeps import seeds


def polygon(*corners: tuple[float, float], closed: bool = True) -> Profile:
    ends = (*corners[1:], corners[0]) if closed else corners[1:]
    spans = tuple(NurbsCurve.line(a, b) for a, b in zip(corners, ends, strict=False))
    return Profile.from_contours([Contour(spans, closed)])


PROFILES = {
    "spline": reference_contour(),
    "small spline": reference_contour(0.3),
    "rectangle": nominal_of("mitres")[1],
    "one round corner": nominal_of("rounds")[1],
    "edge": nominal_of("edge")[1],
    "triangle": polygon((0.0, 0.0), (60.0, 5.0), (20.0, 40.0)),
    "two contours": Profile.from_contours(
        [
            *reference_contour().contours,
            Contour((NurbsCurve.arc((50.0, 42.0), (50.0, 42.0), (42.0, 42.0), -2 * np.pi),), True),
        ]
    ),
}
HEIGHTS = plausibility.CutHeights(np.full(2, -5.0), 2.0)


def kept(m: Measurement, rows: np.ndarray) -> Measurement:
    normals = None if m.normals is None else m.normals[rows]
    return replace(m, points=m.points[rows], normals=normals, lines=m.lines[rows])


def printed(measurement: Measurement, decimals: int = 4) -> Measurement:
    """The measurement as a file gives it."""
    return replace(measurement, points=np.round(measurement.points, decimals))


def machine(seed: int, **more: object) -> tuple[SimulatedMachine, int]:
    """Machine with determined errors up to some 20 um that no shift explains and 0.5 to 5 um of noise; points."""
    rng = np.random.default_rng([seed, 11])
    waves = tuple((int(k), rng.uniform(0.0, 0.004), rng.uniform(0.0, 6.3)) for k in rng.integers(3, 8, 3))
    errors = ErrorField(
        constant=rng.choice([-1.0, 1.0]) * rng.uniform(0.005, 0.02),
        harmonics=waves,
        backlash=(rng.uniform(0.0, 0.003), rng.uniform(0.0, 0.003)),
    )
    noise = rng.uniform(0.0005, 0.005)
    share = rng.uniform(0.0, 1.0)
    made = SimulatedMachine(errors=errors, process_noise=share * noise, measurement_noise=(1.0 - share) * noise, **more)
    return made, int(np.exp(rng.uniform(np.log(30), np.log(2000))))


def away_from_corners(measured: Measurement, profile: Profile) -> Measurement:
    """Nobody probes within a tenth of a millimetre of a sharp corner: the ball rolls off it."""
    joints = np.flatnonzero(np.abs(np.nan_to_num(profile.turn)) > 0.1)
    clear = np.full(len(measured), True)
    for k in joints:
        corner, _ = profile.at(int(profile.contour[k]), profile.begin[k : k + 1] + profile.length[k])
        clear &= np.hypot(*(measured.points[:, :2] - corner[0]).T) > measured.ball_radius + 0.1
    return kept(measured, clear)


def sound(profile: Profile, seed: int, **how: object) -> Measurement:
    """Measurement of a part of such a machine."""
    made, count = machine(seed)
    return away_from_corners(printed(made.follow(profile, seed=seed).measure(count, z=-3.0, seed=seed, **how)), profile)


def examined(measurement: Measurement, profile: Profile) -> tuple[Finding, ...]:
    """Everything that the pipeline asks, in its order; dangerous findings stop it."""
    found = plausibility.examine_file(measurement) + plausibility.examine_points(measurement, profile, 5.0)
    if any(f.dangerous for f in found):
        return found
    d = deviations(measurement, profile, cutter_radius=0.0)
    step = plausibility.resolution(measurement)
    ball = measurement.ball_radius
    return found + plausibility.examine_deviations(d, profile, 5.0, ball_radius=ball, heights=HEIGHTS, step=step)


def names(found: tuple[Finding, ...]) -> set[str]:
    assert {f.name for f in found} <= set(NAMES)
    return {f.name for f in found}


@pytest.mark.parametrize("profile", PROFILES)
@pytest.mark.parametrize("how", [{}, {"normals": True, "order": "shuffled"}, {"points": "centre", "ball_radius": 1.5}])
@pytest.mark.parametrize("seed", seeds(25, quick=3))
def test_a_sound_part_raises_nothing(profile: str, how: dict[str, object], seed: int) -> None:
    assert examined(sound(PROFILES[profile], seed, **how), PROFILES[profile]) == ()


ROUND = nominal_of("rounds")[1]


def hard(profile: Profile, seed: int) -> tuple[Measurement, np.ndarray]:
    """A sound part of a machine that bends, and the true deviations of its points, mm.

    Bends by up to 0.1 mm all along and 0.3 mm in places, unlike along X and Y; out of square, long waves, worn tool;
    40 to 3,000 points, even or not, of a contour less a gap, at one or two heights, 2 % outliers of up to 0.3 mm.
    """
    rng = np.random.default_rng([seed, 7])
    count = int(np.exp(rng.uniform(np.log(40), np.log(3000))))
    contour = int(rng.integers(len(profile.contours)))
    total = float(profile.total[contour])
    steps = np.cumsum(np.ones(count) if rng.random() < 0.5 else rng.uniform(1.0, 5.0, count))
    s = 0.5 + steps / steps[-1] * (total - 1.0)
    if rng.random() < 0.3:
        begin = rng.uniform(0.1, 0.8) * total
        s = s[(s < begin) | (s > begin + rng.uniform(0.02, 0.08) * total)]
    s = np.tile(s, 1 + (seed % 3 == 0))
    z = np.where(np.arange(len(s)) < len(s) // (1 + (seed % 3 == 0)), -3.0, -2.0)
    foot, normal = profile.at(np.full(len(s), contour), s)
    bends = rng.choice([0.005, 0.015, 0.04, 0.1]) * rng.uniform(0.7, 1.0)
    true = bends * (1.0 + rng.uniform(-0.1, 0.1) * normal[:, 0] ** 2) - rng.normal(0.0, 0.005)
    for _ in range(int(rng.integers(0, 4))):
        away = np.hypot(*(foot - foot[rng.integers(len(foot))]).T)
        true += bends * rng.uniform(0.3, 2.0) * np.exp(-((away / rng.uniform(3.0, 15.0)) ** 2))
    middle = foot.mean(axis=0)
    x, y = (foot - middle).T
    field = np.column_stack([rng.normal(0, 3e-5) * x + rng.normal(0, 3e-5) * y, rng.normal(0, 3e-5) * y])
    for _ in range(int(rng.integers(1, 4))):
        wave = rng.uniform(0.001, 0.008) * np.sin(2 * np.pi * foot[:, rng.integers(2)] / rng.uniform(25, 150) + seed)
        field[:, rng.integers(2)] += wave
    true += (field * normal).sum(axis=1)
    seen = true + rng.choice([0.001, 0.003]) * rng.standard_normal(len(s))
    wrong = rng.random(len(s)) < rng.choice([0.0, 0.005, 0.02])
    seen += wrong * rng.choice([-1.0, 1.0], len(s)) * rng.uniform(0.03, 0.3, len(s))
    ball = float(rng.choice([0.0, 1.5]))
    points = np.column_stack([foot + (seen + ball)[:, None] * normal, z])
    normals = np.column_stack([normal, 0.0 * z]) if rng.random() < 0.5 else None
    order = rng.permutation(len(s))
    m = Measurement(points, normals, ball, np.arange(1, len(s) + 1), "part.csv", f"{seed:064x}")
    return away_from_corners(printed(kept(m, order)), profile), true


@pytest.mark.parametrize("profile", PROFILES)
@pytest.mark.parametrize("seed", seeds(100, quick=8))
def test_a_machine_that_bends_is_corrected(profile: str, seed: int) -> None:
    """A mean that is really there is said; nothing else is, and nothing stops."""
    nominal = PROFILES[profile]
    m, true = hard(nominal, seed)
    found = examined(m, nominal)
    assert names(found) <= {"constant-offset"} and not any(f.dangerous for f in found), [f.text for f in found]
    assert not found or abs(true.mean()) > 0.02, found[0].text


@pytest.mark.parametrize("by", [0.05, 0.1, 0.19, -0.05, -0.1, -0.19])
@pytest.mark.parametrize("ball", [0.0, 1.0])
def test_a_mean_is_explained_figure_by_figure(by: float, ball: float) -> None:
    (finding,) = examined(replace(outwards(sound_without_mean(), by + ball), ball_radius=ball), SPLINE)
    assert finding.name == "constant-offset" and not finding.dangerous and "mean" in finding.text
    numbers = [float(n) for n in re.findall(r"[-+]?[0-9]+\.?[0-9]*", finding.text)]
    for figure in (1000 * by, ball + by if ball else abs(by), 10 - 2 * by, *([by] if by > 0 else [])):
        assert min(abs(n - figure) for n in numbers) < 0.005 * max(abs(figure), 1.0), (figure, finding.text)


def test_degrees_are_named_only_where_they_are_plausible() -> None:
    """A ring of 300 mm is 0.03 mm too large at 17 K; one of 30 mm would need 174 K."""
    for radius, plausible in ((150.0, True), (15.0, False)):
        ring = Contour((NurbsCurve.arc((radius, 0.0), (radius, 0.0), (0.0, 0.0), 2 * np.pi),), True)
        profile = Profile.from_contours([ring])
        angle = np.linspace(0.0, 6.2, 200)
        points = (radius + 0.03) * np.column_stack([np.cos(angle), np.sin(angle), 0.0 * angle])
        (finding,) = examined(Measurement(points, None, 0.0, np.arange(1, 201), "ring.csv", "ab" * 32), profile)
        assert ("17 K too warm" in finding.text) == plausible, finding.text


def sound_without_mean() -> Measurement:
    m = sound(SPLINE, 1)
    return outwards(m, -float(np.median(deviations(m, SPLINE).value)))


@pytest.mark.parametrize("profile", ["rectangle", "one round corner"])
@pytest.mark.parametrize("by", [0.1, 0.2, -0.1, -0.25])
def test_a_side_of_another_revision_is_named(profile: str, by: float) -> None:
    """The part was cut with its right side 0.1 or 0.2 mm farther out, or in; at 0.25 mm too deep it stops."""
    nominal = PROFILES[profile]
    for seed in range(4):
        m = sound(nominal, seed)
        d = deviations(m, nominal)
        points = m.points[d.index].copy()
        side = d.normal @ d.normal[np.argmax(d.foot[:, 0])] > 0.99
        points[side, :2] += by * d.normal[side]
        found = examined(replace(m, points=points, lines=m.lines[d.index]), nominal)
        assert names(found) == {"step"}, [f.text for f in found]
        (finding,) = found
        assert finding.figure == pytest.approx(by, abs=0.025) and finding.dangerous == (by < -0.2)


def web(thickness: float, angle: float) -> Profile:
    """A web of 40 mm with square ends, turned."""
    c, s = np.cos(angle), np.sin(angle)
    corners = np.array([(0.0, 0.0), (40.0, 0.0), (40.0, thickness), (0.0, thickness)]) @ [[c, s], [-s, c]]
    return polygon(*(tuple(corner) for corner in corners))


def ring(thickness: float, radius: float) -> Profile:
    """Half a ring of this outer radius."""
    inner = radius - thickness
    spans = (
        NurbsCurve.arc((radius, 0.0), (-radius, 0.0), (0.0, 0.0), np.pi),
        NurbsCurve.line((-radius, 0.0), (-inner, 0.0)),
        NurbsCurve.arc((-inner, 0.0), (inner, 0.0), (0.0, 0.0), -np.pi),
        NurbsCurve.line((inner, 0.0), (radius, 0.0)),
    )
    return Profile.from_contours([Contour(spans, True)])


@given(
    thickness=st.floats(0.3, 1.0),
    shape=st.floats(0.0, 6.0),
    bent=st.booleans(),
    ball=st.sampled_from([0.0, 0.5, 1.0]),
    seed=st.integers(0, 999),
)
def test_points_of_a_thin_web_belong_to_the_side_that_their_normals_say(
    thickness: float, shape: float, bent: bool, ball: float, seed: int
) -> None:
    """Deviations of up to 0.2 mm on both sides of 0.3 to 1 mm, normals as a file gives them: exact to 0.1 um."""
    profile = ring(thickness, 10.0 + 5.0 * shape) if bent else web(thickness, shape)
    rng = np.random.default_rng(seed)
    long = np.flatnonzero(profile.length > 1.0)
    span = rng.choice(long, 100)
    t = rng.uniform(0.02, 0.98, 100)
    foot, _, _ = profile.evaluate(span, t)
    # Not where the web ends: a corner's other side is nearer than the web is thick.
    ends = np.concatenate(
        [
            profile.ends(0)[0][None],
            *(
                profile.evaluate(np.array([k]), np.array([e]))[0]
                for k in np.flatnonzero(profile.length <= 1.0)
                for e in (0.0, 1.0)
            ),
        ]
    )
    clear = np.hypot(*(foot[:, None] - ends[None]).T).min(axis=0) > 0.5
    foot, normal = foot[clear], profile.normals(span, t)[clear]
    true = rng.uniform(-0.2, 0.2, len(foot)) if seed % 2 else np.full(len(foot), rng.choice([-0.2, 0.2]))
    points = np.column_stack([foot + (true + ball)[:, None] * normal, np.zeros(len(foot))])
    turn = rng.normal(0.0, 0.05, len(foot))
    as_file = normal * np.cos(turn)[:, None] + np.column_stack([-normal[:, 1], normal[:, 0]]) * np.sin(turn)[:, None]
    normals = np.round(np.column_stack([as_file, 0.0 * turn]), 4)
    m = Measurement(points, normals, ball, np.arange(1, len(foot) + 1), "web.csv", "ab" * 32)
    d = deviations(m, profile)
    assert len(d) == len(foot)
    np.testing.assert_allclose(d.value, true, atol=1e-4)
    assert "thin-wall" not in names(plausibility.examine_points(m, profile, 5.0))


SPLINE = PROFILES["spline"]
TURN = np.radians(0.08)


def moved(m: Measurement, change) -> Measurement:
    return replace(m, points=change(m.points.copy()))


def with_z(m: Measurement, z: float, every: int = 1) -> Measurement:
    points = m.points.copy()
    points[::every, 2] = z
    return replace(m, points=points)


def outwards(m: Measurement, by: float, every: int = 1) -> Measurement:
    """Points moved along the nominal's normal by so many mm."""
    d = deviations(replace(m, ball_radius=0.0), SPLINE, reach=20.0)
    points = m.points.copy()
    points[d.index[::every], :2] += by * d.normal[::every]
    return replace(m, points=points)


def beside_its_nominal(m: Measurement, spread: float) -> Measurement:
    d = deviations(m, SPLINE)
    points = np.column_stack([d.foot, m.points[d.index, 2]])
    normals = np.column_stack([d.normal, np.zeros(len(d))])
    actual = points + spread * d.value[:, None] * normals
    return replace(m, points=actual, nominal=points, normals=normals, stated=d.value * spread)


def turned_a_little(points: np.ndarray) -> np.ndarray:
    c, s = np.cos(TURN), np.sin(TURN)
    out = points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    return out + [0.02, -0.03, 0.0]


SPOILT = {
    # name: (what spoils a sound measurement of the spline, dangerous)
    "unit": (lambda m: moved(m, lambda p: p / 25.4), True),
    "mirrored": (lambda m: moved(m, lambda p: p[:, [1, 0, 2]]), True),
    "turned": (lambda m: moved(m, lambda p: -p), True),
    "ball-not-compensated": (lambda m: outwards(m, 1.5), True),
    "compensated-twice": (lambda m: replace(m, ball_radius=1.5), True),
    "diameter-for-radius": (lambda m: replace(outwards(m, 1.5), ball_radius=3.0), True),
    "radius-for-diameter": (lambda m: replace(outwards(m, 1.5), ball_radius=0.75), True),
    "wrong-side": (lambda m: outwards(m, -10.0), True),
    "constant-offset": (lambda m: outwards(m, -0.35), True),
    "misalignment": (lambda m: moved(m, turned_a_little), True),
    "scale": (lambda m: moved(m, lambda p: 52.0 + (p - 52.0) * [1.0025, 1.0025, 1.0]), True),
    "identical-to-nominal": (lambda m: printed(beside_its_nominal(m, 0.0), 3), False),
    "wrong-level": (lambda m: with_z(m, -40.0), True),
    "below-the-cut": (lambda m: with_z(m, -6.0, 7), False),
    "above-the-cut": (lambda m: with_z(m, 4.0, 7), False),
    "coarse-resolution": (lambda m: printed(m, 2), False),
    "other-nominal": (
        lambda m: replace(beside_its_nominal(m, 1.0), nominal=beside_its_nominal(m, 1.0).nominal + [0.3, 0.0, 0.0]),
        True,
    ),
    "stated-deviations": (
        lambda m: replace(beside_its_nominal(m, 1.0), stated=-beside_its_nominal(m, 1.0).stated),
        True,
    ),
    "many-rejected": (lambda m: outwards(m, 2.5, 2), True),
}


@pytest.mark.parametrize("name", SPOILT)
@pytest.mark.parametrize("seed", seeds(20, quick=3))
def test_a_spoilt_measurement_is_found(name: str, seed: int) -> None:
    spoil, dangerous = SPOILT[name]
    found = examined(spoil(sound(SPLINE, seed)), SPLINE)
    assert name in names(found), [f.text for f in found]
    finding = next(f for f in found if f.name == name)
    assert finding.dangerous == dangerous, finding.text
    assert any(c.isdigit() for c in finding.text), finding.text


WALL = 0.3
THIN = polygon((0.0, 0.0), (80.0, 0.0), (80.0, WALL), (0.0, WALL))


def on_the_lower_side(seed: int, off: float, *, normals: bool) -> Measurement:
    rng = np.random.default_rng(seed)
    x = np.linspace(2.0, 78.0, 60)
    points = np.column_stack([x, -np.where(x < 20, off, 0.02) + 0.002 * rng.standard_normal(60), np.full(60, -3.0)])
    outward = np.tile([0.0, -1.0, 0.0], (60, 1))
    return Measurement(points, outward if normals else None, 0.0, np.arange(1, 61), "wall.csv", "cd" * 32)


def test_a_wall_measured_within_its_tolerance_raises_nothing() -> None:
    for seed in range(10):
        for normals in (True, False):
            found = plausibility.examine_points(on_the_lower_side(seed, 0.02, normals=normals), THIN, 5.0)
            assert found == (), seed


def test_points_nearer_to_the_other_side_of_a_wall_need_normals() -> None:
    """An undercut of 0.18 mm of a wall of 0.3 mm lies 0.12 mm from the side opposite."""
    for seed in range(10):
        assert plausibility.examine_points(on_the_lower_side(seed, -0.18, normals=True), THIN, 5.0) == ()
        (finding,) = plausibility.examine_points(on_the_lower_side(seed, -0.18, normals=False), THIN, 5.0)
        assert finding.name == "thin-wall" and finding.dangerous
        assert "may be meant: 14, the thinnest wall 0.300 mm (" in finding.text and "wall.csv:" in finding.text


def test_normals_into_the_material_are_found() -> None:
    wall = on_the_lower_side(1, 0.02, normals=True)
    assert wall.normals is not None
    (finding,) = plausibility.examine_points(replace(wall, normals=-wall.normals), THIN, 5.0)
    assert finding.name == "normals-reversed" and finding.dangerous and "60 of 60" in finding.text
    solid = sound(SPLINE, 3, normals=True)
    assert solid.normals is not None
    (finding,) = plausibility.examine_points(replace(solid, normals=-solid.normals), SPLINE, 5.0)
    assert finding.name == "normals-reversed" and not finding.dangerous


@pytest.mark.parametrize("seed", seeds(5, quick=3))
def test_points_shifted_along_the_axes_are_found(seed: int) -> None:
    """A control that takes the ball off along the axis of travel leaves r (1/cos - 1) or r (1 - cos) on slopes."""
    m = outwards(sound(SPLINE, seed), 3.0)
    d = deviations(replace(m, ball_radius=3.0), SPLINE)
    points = m.points[d.index].copy()
    axis = np.where(np.abs(d.normal[:, :1]) > np.abs(d.normal[:, 1:]), [1.0, 0.0], [0.0, 1.0])
    points[:, :2] -= 3.0 * axis * np.sign(d.normal)
    found = examined(replace(m, points=points, lines=m.lines[d.index]), SPLINE)
    assert names(found) == {"axis-compensated"}, [f.text for f in found]


def as_a_control_reports(m: Measurement, profile: Profile, radius: float) -> Measurement:
    """Contact points as a cycle gives them that takes the ball's radius off along the axis of travel."""
    d = deviations(m, profile)
    # Within a degree or two of 45 degrees nobody can tell along which axis a point was touched.
    n = d.normal[(clear := np.abs(np.abs(d.normal[:, 0]) - np.abs(d.normal[:, 1])) > 0.06)]
    travel = np.where(np.abs(n[:, :1]) > np.abs(n[:, 1:]), [1.0, 0.0], [0.0, 1.0]) * -np.sign(n)
    points = m.points[d.index[clear]].copy()
    points[:, :2] += radius * (n + travel)
    return printed(replace(kept(m, d.index[clear]), points=points, axis_radii=(radius, radius)))


SLOPED = ("spline", "small spline", "triangle", "two contours")
"""Elsewhere nearly all normals lie along an axis, where the radius of a shift makes no difference."""


@pytest.mark.parametrize("profile", PROFILES)
@pytest.mark.parametrize("seed", seeds(25, quick=3))
def test_the_radius_of_a_shift_along_the_axis_is_judged(profile: str, seed: int) -> None:
    nominal = PROFILES[profile]
    m = sound(nominal, seed)
    radius = float(np.random.default_rng([seed, 5]).choice([1.0, 1.5, 2.0, 3.0]))
    if profile == "small spline":
        # Half of its smallest radius of curvature, 4.6 mm: about a larger ball points change sides.
        radius = min(radius, 2.0)
    shifted = as_a_control_reports(m, nominal, radius)

    def said(m: Measurement) -> str | None:
        found = axis_residue(m, contact_known(m, nominal), nominal)
        return found and found[0]

    assert said(shifted) is None
    if profile in SLOPED:
        assert said(replace(shifted, axis_radii=(0.5 * radius, 0.5 * radius))) == "axis-radius"
        assert said(replace(shifted, axis_radii=(2.0 * radius, 2.0 * radius))) == "axis-radius"
        assert said(replace(m, axis_radii=(radius, radius))) == "not-axis-compensated"


@pytest.mark.few(1)
@pytest.mark.parametrize("filter", ["auto", "robust:15"])
@pytest.mark.parametrize("seed", seeds(10, quick=2))
def test_a_loop_of_sound_parts_goes_through_and_mixed_up_ones_do_not(filter: str, seed: int) -> None:
    """Part, corrected program, its part; half a one; in place of them the first program's part, the same part again."""
    made, count = machine(seed, transfer=0.04, allowance=0.3, wear_per_part=0.001)
    # Fewer points than noise of this size needs say nothing of the program; the sweep below has them.
    count = max(count, 200)
    settings = pipeline.Settings(filter=filter, side="right")

    def part(program: nc.Program, number: int, count: int = count) -> Measurement:
        cut = made.cut(program.toolpath, 5.0, SPLINE, worn=0.001 * number, seed=100 * seed + number)
        found = printed(cut.measure(count, z=-3.0, seed=100 * seed + number))
        return replace(found, source=f"part-{number}.csv", digest=f"{number:064x}")

    def correct(program: nc.Program, *parts: Measurement) -> pipeline.Result:
        return pipeline.correct(pipeline.Request(program, 5.0, parts[0], SPLINE, settings, parts[1:]))

    first, other = part(PROGRAM, 1), part(PROGRAM, 2, count=int(0.8 * count))
    corrected = correct(PROGRAM, first)
    second = nc.parse(corrected.text, "second.nc")
    assert correct(second, part(second, 3)).text
    assert correct(PROGRAM, first, other).text
    for again in (printed(first, 3), replace(kept(first, np.arange(1, count)), digest="9" * 64)):
        with pytest.raises(DistrustError, match="--accept same-part"):
            correct(PROGRAM, first, again)
    half = kept(other, other.points[:, 0] < 52.0)
    assert correct(PROGRAM, half, first).text
    # With 160 points a slope of 1 is then certain to 8 standard deviations at least.
    if corrected.filtered.std() > corrected.random_std:
        with pytest.raises(DistrustError, match="--accept earlier-program"):
            correct(second, other)


def parts_and_correction(profile: Profile, seed: int) -> tuple[Deviation, Deviation, Deviation, Correction]:
    """Used points of a part, of the next one and of one with other errors, and the correction made from the first."""
    made, count = machine(seed, transfer=0.04, allowance=0.3, wear_per_part=0.001)
    filter = ("auto", "none", "mean:5", "robust:15")[seed % 4]

    def used(cut: SimulatedPart, seed: int) -> Deviation:
        return deviations(away_from_corners(printed(cut.measure(count, z=-3.0, seed=seed)), profile), profile)

    first = used(made.follow(profile, seed=seed), seed)
    settings = pipeline.Settings(filter=filter, limit=2.0)
    work = wanted_displacement([Part(first, np.zeros(len(first)), first.value)], profile, settings, False)
    correction, _ = correction_through(work, profile, settings)
    stretches = profile.stretches()

    def shift(contour: int, s: np.ndarray) -> np.ndarray:
        own = [k for k, stretch in enumerate(stretches) if stretch.contour == contour]
        begin = np.array([stretches[k].begin for k in own])
        return correction.at(np.array(own)[np.searchsorted(begin, s, side="right") - 1], s, profile)

    again = used(made.follow(profile, seed=seed + 1000), seed + 1000)
    following = used(made.follow(profile, shift=shift, seed=seed + 2000), seed + 2000)
    other, _ = machine(seed + 500)
    drifted = replace(made, errors=replace(made.errors, harmonics=other.errors.harmonics))
    elsewhere = used(drifted.follow(profile, shift=shift, seed=seed + 3000), seed + 3000)
    return again, following, elsewhere, correction


@pytest.mark.few(6)
@pytest.mark.parametrize("profile", ["spline", "rectangle", "triangle", "two contours"])
@pytest.mark.parametrize("seed", seeds(50, quick=5))
def test_no_part_of_the_program_itself_is_taken_for_an_earlier_one(profile: str, seed: int) -> None:
    nominal = PROFILES[profile]
    _, following, elsewhere, correction = parts_and_correction(nominal, seed)
    for d in (following, elsewhere):
        assert plausibility.examine_program(d, correction.at(d.stretch, d.s, nominal)) == ()


@pytest.mark.slow
def test_three_of_four_parts_of_an_earlier_program_are_seen_whatever_the_noise() -> None:
    """Down to 30 points and up to noise larger than the errors; from two standard deviations on all of them."""
    found, clear, clear_found = 0, 0, 0
    for seed in range(60):
        again, _, _, correction = parts_and_correction(SPLINE, seed)
        offset = correction.at(again.stretch, again.s, SPLINE)
        seen = plausibility.examine_program(again, offset) != ()
        found += seen
        if offset.std() > 2.0 * (again.value + offset).std():
            clear, clear_found = clear + 1, clear_found + seen
    assert found >= 42 and clear > 5 and clear_found == clear


def test_every_name_is_tested() -> None:
    elsewhere = {
        "unmeasured",
        "outliers",
        "many-levels",
        "step",
        "earlier-program",
        "same-part",
        "first-part",
        "not-axis-compensated",
        "axis-radius",
        # A file's own, in test_inspect_and_convert.
        "height-map",
        "implausible-radius",
        "implausible-extent",
    }
    assert set(NAMES) == set(SPOILT) | elsewhere | {"thin-wall", "normals-reversed", "axis-compensated"}


@pytest.mark.parametrize(("decimals", "unit"), [(1, "mm"), (3, "mm"), (4, "mm"), (3, "inch"), (5, "inch")])
def test_the_resolution_of_a_file_is_seen(decimals: int, unit: str) -> None:
    factor = 25.4 if unit == "inch" else 1.0
    for seed in range(10):
        m = sound(SPLINE, seed)
        as_read = replace(m, points=np.round(m.points / factor, decimals) * factor, unit=unit)
        assert plausibility.resolution(as_read) == pytest.approx(factor * 10.0**-decimals)


def test_computed_points_have_no_resolution() -> None:
    m = SimulatedMachine.reference().follow(SPLINE, seed=1).measure(50, seed=1)
    assert plausibility.resolution(m) == 0.0


@pytest.mark.parametrize("decimals", [3, 4])
def test_rounding_is_no_measurement(decimals: int) -> None:
    """Rounding two coordinates to q moves a point along its normal by at most q / sqrt(2)."""
    for count in (30, 500):
        m = SimulatedMachine().follow(SPLINE, seed=1).measure(count, z=-3.0, seed=1)
        (finding,) = examined(printed(m, decimals), SPLINE)
        assert finding.name == "identical-to-nominal"


@pytest.mark.parametrize("seed", seeds(20, quick=5))
def test_stated_deviations_of_a_rounded_file_agree(seed: int) -> None:
    m = beside_its_nominal(sound(SPLINE, seed), 1.0)
    assert m.nominal is not None and m.stated is not None
    for decimals in (2, 3, 4):
        stated = np.round(m.stated, decimals) if decimals > 2 else m.stated
        rounded = replace(printed(m, decimals), nominal=np.round(m.nominal, decimals), stated=stated)
        assert "stated-deviations" not in names(plausibility.examine_file(rounded))
