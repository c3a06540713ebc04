# SPDX-License-Identifier: LGPL-2.1-or-later
"""A model of the part says where a wall stands, at which height it is touched, and what stands in the way."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from millcorr import nc
from millcorr.__main__ import main
from millcorr.errors import RefusedError, UsageError
from millcorr.probing import Placement, TouchProbe
from millcorr.probing.controls import Cleared, heights, measuring_program
from millcorr.probing.workpiece import Workpiece
from tests.core.contours import rectangle
from tests.core.measuring_machine import CONTROLS, Alarm, Collision, Machine
from tests.core.probing.test_measuring_programs import MILLING

RADIUS, MARGIN = 2.5, 0.5
BLOCK = rectangle(60, 40).profile
RING = np.array([[0.0, 0.0], [60.0, 0.0], [60.0, 40.0], [0.0, 40.0]])


def prism(ring: np.ndarray, bottom: float, top: float, share: float = 1.0) -> np.ndarray:
    """Facets of a convex prism, its upper face shrunk to a share about its centre."""
    low = np.column_stack([ring, np.full(len(ring), bottom)])
    high = np.column_stack([ring.mean(axis=0) + share * (ring - ring.mean(axis=0)), np.full(len(ring), top)])
    n = len(ring)
    fan = [(0, k, k + 1) for k in range(1, n - 1)]
    out = [high[list(f)] for f in fan] + [low[list(f)][::-1] for f in fan]
    for k in range(n):
        a, b = k, (k + 1) % n
        out += [np.array([low[a], low[b], high[b]]), np.array([low[a], high[b], high[a]])]
    return np.array(out)


def asked(part: np.ndarray | None, **more: object) -> object:
    options = {"z": 6.0, "safe_z": 30.0, "probe": TouchProbe(RADIUS), "placement": Placement(count=40), **more}
    workpiece = None if part is None else Workpiece(part)
    return measuring_program(BLOCK, dialect="haas", workpiece=workpiece, **options)


def suggested(part: np.ndarray, **more: object) -> tuple[float | None, float | None]:
    return heights(BLOCK, Placement(count=40), TouchProbe(RADIUS), workpiece=Workpiece(part), **more)


def cut_to(z: float) -> Cleared:
    return Cleared(nc.parse(MILLING.replace(b"Z-10", b"Z%g" % z)).toolpath, 5.0)


@pytest.mark.parametrize(
    ("bottom", "top", "floor", "z"),
    # On the table, cut through; with the origin on top; cut half way down.
    [(0.0, 12.0, -1.0, 6.0), (-12.0, 0.0, -13.0, -6.0), (0.0, 12.0, 4.0, 8.0)],
)
def test_it_is_measured_in_the_middle_of_the_wall_that_is_cut(
    bottom: float, top: float, floor: float, z: float
) -> None:
    assert suggested(prism(RING, bottom, top), cleared=cut_to(floor))[0] == pytest.approx(z)
    made = asked(prism(RING, bottom, top), cleared=cut_to(floor), z=z)
    assert len(made.plan) == 40 and not made.warnings


def test_below_the_part_nothing_is_touched() -> None:
    """The demonstration's part stands from Z0 to Z12, and its path runs at Z-1."""
    part = prism(RING, 0.0, 12.0)
    with pytest.raises(RefusedError, match="no wall stands there .* check --z"):
        asked(part, z=-0.5, cleared=cut_to(-1.0))
    for above in (11.6, 30.0):
        with pytest.raises(RefusedError, match="no wall stands there"):
            asked(part, z=above, safe_z=40.0)


@pytest.mark.parametrize(
    ("z", "tip", "centre"),
    [(0.4, None, None), (0.6, True, False), (2.9, True, False), (3.1, True, True), (8.9, True, True),
     (9.1, False, True), (11.4, False, True), (11.6, None, None)],
)  # fmt: skip
def test_near_the_ends_it_matters_how_the_length_was_set(z: float, tip: bool | None, centre: bool | None) -> None:
    """Set to the tip, the touch is a radius above the height; set to the centre, the tip is a radius below it."""
    if tip is None:
        with pytest.raises(RefusedError):
            asked(prism(RING, 0.0, 12.0), z=z)
        return
    warned = " ".join(asked(prism(RING, 0.0, 12.0), z=z).warnings)
    assert ("set to the tip" in warned) == (not centre) and ("set to the centre" in warned) == (not tip)


def test_a_wall_too_low_for_both_is_the_users_choice() -> None:
    low = prism(RING, 0.0, 2 * (RADIUS + MARGIN) - 0.1)
    assert suggested(low)[0] is None
    assert suggested(prism(RING, 0.0, 2 * (RADIUS + MARGIN) + 0.1))[0] == pytest.approx(RADIUS + MARGIN + 0.05)


def test_where_the_wall_is_lower_it_is_not_touched() -> None:
    """Right of X30 the part is 5 mm high: at Z8 nothing stands there, and that height suits most places."""
    left, right = RING.clip([0, 0], [30, 40]), RING.clip([30, 0], [60, 40])
    part = np.concatenate([prism(left, 0.0, 16.0), prism(right, 0.0, 5.0)])
    made = asked(part, z=8.0, safe_z=30.0)
    assert len(made.plan) and (made.plan.contact[:, 0] < 30).all()
    lost = [left_out for left_out in made.plan.left_out if "no wall" in left_out.reason]
    assert lost and all(left_out.x > 30 for left_out in lost)
    wide = np.concatenate(
        [prism(RING.clip([0, 0], [20, 40]), 0.0, 30.0), prism(RING.clip([20, 0], [60, 40]), 0.0, 8.0)]
    )
    assert suggested(wide)[0] == pytest.approx(4.0)


def test_the_probe_passes_over_the_model() -> None:
    part = np.concatenate([prism(RING, 0.0, 12.0), prism(RING / 10 + [25, 15], 12.0, 40.0)])
    assert suggested(part, cleared=cut_to(-1.0))[1] == pytest.approx(40.0 + RADIUS + MARGIN)
    with pytest.raises(UsageError, match="--safe-z 42 lies below Z43.000, the top of the model .* say --safe-z 43"):
        asked(part, safe_z=42.0)
    assert asked(part, safe_z=43.0)


def test_ways_keep_clear_of_what_stands_beside_the_contour() -> None:
    """A post beside the wall: a program that knows nothing of it drives into it, one that does goes over."""
    post = np.array([[28.0, -9.0], [32.0, -9.0], [32.0, -5.0], [28.0, -5.0]])
    both = np.concatenate([prism(RING, 0.0, 12.0), prism(post, 0.0, 20.0)])
    area, block = shapely.Polygon(post), shapely.Polygon(RING)

    def distance(points: np.ndarray) -> np.ndarray:
        at = shapely.points(points)
        outside = np.minimum(shapely.distance(at, block), shapely.distance(at, area))
        return np.where(shapely.contains(block, at) | shapely.contains(area, at), -1.0, outside)

    with pytest.raises((Alarm, Collision)):
        CONTROLS["haas"](asked(None).text, Machine(distance, RADIUS, top=20.0), {})
    made = asked(both)
    assert 20 < len(made.plan) < 40 and any(link is None for link in made.plan.links)
    ran = CONTROLS["haas"](made.text, Machine(distance, RADIUS, top=20.0), {})
    assert ran.touches == len(made.plan)
    # A low step is passed over at that height.
    low = np.concatenate([prism(RING, 0.0, 12.0), prism(post, 0.0, 3.0)])
    assert len(asked(low).plan) == 40


def test_a_model_without_the_contour_decides_nothing() -> None:
    raw = prism(RING * 3 - 40, 0.0, 12.0)
    made = asked(raw, cleared=cut_to(-1.0), safe_z=20.0)
    assert len(made.plan) == 40 and "no wall on this contour" in made.warnings[0]


def test_passes_do_not_vouch_for_a_wall_above_them() -> None:
    made = measuring_program(
        BLOCK, dialect="haas", probe=TouchProbe(RADIUS), placement=Placement(count=8), z=-3, safe_z=20,
        cleared=cut_to(-10),
    )  # fmt: skip
    assert any("nothing shows that the wall stands as high as Z-3" in warning for warning in made.warnings)


@given(
    bottom=st.floats(-20, 20), height=st.floats(0.5, 40), share=st.floats(0.3, 1.0), at=st.floats(0.02, 0.98),
    turned=st.floats(0, 6.2), sides=st.integers(3, 9),
)  # fmt: skip
def test_what_stands_above_a_height_is_the_section_there(
    bottom: float, height: float, share: float, at: float, turned: float, sides: int
) -> None:
    """A frustum, cut at a share of its height: its section is the ring shrunk by that share (closed form)."""
    angle = turned + np.arange(sides) * 2 * np.pi / sides
    ring = np.column_stack([np.cos(angle), np.sin(angle)]) * [30.0, 20.0]
    part = Workpiece(prism(ring, bottom, bottom + height, share))
    section = shapely.Polygon(ring.mean(axis=0) + (1 + (share - 1) * at) * (ring - ring.mean(axis=0)))
    found = part.above(bottom + at * height)
    assert found.area.symmetric_difference(section).area < 1e-6 * section.area
    points = np.random.default_rng(1).uniform(-60, 60, (50, 2))
    expected = shapely.distance(shapely.points(points), section)
    away = expected > 0
    assert np.abs(found.distance(points) - expected - part.tolerance)[away].max() < 1e-6
    assert (found.distance(points)[~away] == 0).all()


# To a micrometre: heights nearer to each other than a nanometre are one to the model.
@given(
    st.lists(
        st.tuples(
            st.integers(-20_000, 20_000).map(lambda z: z / 1000), st.integers(500, 10_000).map(lambda h: h / 1000)
        ),
        min_size=1,
        max_size=4,
    )
)
def test_walls_are_the_stretches_of_material_with_nothing_before_them(pieces: list[tuple[float, float]]) -> None:
    """Plates over each other, as the union of their intervals (shapely, on a line)."""
    part = Workpiece(np.concatenate([prism(RING, low, low + high) for low, high in pieces]))
    found = part.walls(np.array([[30.0, 0.0], [90.0, 0.0]]), np.array([[0.0, -1.0], [1.0, 0.0]]))
    lines = shapely.union_all([shapely.LineString([(low, 0), (low + high, 0)]) for low, high in pieces])
    expected = sorted(line.bounds[::2] for line in shapely.get_parts(lines.simplify(0)))
    merged: list[list[float]] = []
    for low, high in expected:
        if merged and low <= merged[-1][1] + 1e-9:
            merged[-1][1] = max(high, merged[-1][1])
        else:
            merged.append([low, high])
    assert (found.place == 0).all() and len(found.place) == len(merged)
    assert np.allclose(np.column_stack([found.bottom, found.top]), merged, atol=1e-9)


def test_a_plate_before_the_wall_is_its_bottom() -> None:
    part = np.concatenate([prism(RING * 3 - 40, -5.0, 0.0), prism(RING, 0.0, 12.0)])
    walls = Workpiece(part).walls(np.array([[30.0, 0.0]]), np.array([[0.0, -1.0]]))
    assert walls.bottom.tolist() == [0.0] and walls.top.tolist() == [12.0]
    assert len(asked(part, z=6.0).plan) == 40


def test_the_command_line_takes_the_part_as_stl(tmp_path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "part.nc").write_bytes(MILLING.replace(b"Z-10", b"Z-1"))
    facets = prism(RING, 0.0, 12.0)
    text = "solid part\n"
    for facet in facets:
        corners = "".join(f"vertex {x} {y} {z}\n" for x, y, z in facet)
        text += f"facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n"
    (tmp_path / "part.stl").write_text(text + "endsolid part\n")
    line = (
        "probe --program part.nc --tool-diameter 10 --side right --probe-radius 2.5 --dialect linuxcnc "
        "--output probe.ngc --model part.stl"
    )
    assert main(line.split()) == 0
    low = nc.parse((tmp_path / "probe.ngc").read_bytes()).toolpath.end[:, 2]
    assert np.nanmin(low) == 6.0
    assert main([*line.split(), "--z", "-0.5"]) == 4
    assert "no wall stands there" in capsys.readouterr().err
