# SPDX-License-Identifier: LGPL-2.1-or-later
"""Setup files: what is read, and that every bad one ends in one line that names its key."""

from __future__ import annotations

from pathlib import Path

import pytest

from millcorr.errors import FormatError, MillcorrError, UsageError
from millcorr.process.setup_file import Setup, from_dict, load

SETUPS = Path(__file__).resolve().parents[3] / "resources" / "setups"


def tables(**changes):
    """A good setup; a change `tool__flutes=3` sets a key, None takes it away."""
    data = {
        "tool": {"diameter_mm": 10, "flutes": 4, "spindle_rpm": 3000, "overhang_mm": 40.0},
        "material": {"ktc_n_per_mm2": 2000, "krc_n_per_mm2": 600, "origin": "example"},
        "machine": {"kx_n_per_mm": 8000, "ky_n_per_mm": 5000.0},
        "stock": {"allowance_mm": 0.5, "axial_depth_mm": 5},
    }
    for name, value in changes.items():
        table, _, key = name.partition("__")
        if not key:
            data[table] = value
        elif value is None:
            del data[table][key]
        else:
            data.setdefault(table, {})[key] = value
    return data


def test_good():
    setup = from_dict(tables())
    assert setup.tool.radius == 5.0 and setup.tool.tooth_frequency == 200.0
    assert isinstance(setup.machine.kx_n_per_mm, float)
    assert setup.machine.stiffness() == (8000.0, 5000.0)
    assert setup.tool.effective_diameter_factor == 0.8
    assert "factor of two" in setup.material.caution() and "example" in setup.material.caution()
    assert from_dict(tables(material__calibrated=True)).material.caution() == ""


def test_a_fitted_stiffness_says_so():
    fitted = from_dict(tables(machine__origin="fitted to figure 8"))
    assert fitted.cautions[1] == "stiffness of 8000 and 5000 N/mm: fitted to figure 8"
    assert from_dict(tables(material__calibrated=True)).cautions == ()


@pytest.mark.parametrize("path", sorted(SETUPS.glob("*.toml")), ids=lambda p: p.stem)
def test_examples_are_read_and_name_their_origin(path):
    setup = load(path)
    assert isinstance(setup, Setup) and setup.source == str(path) and setup.material.origin
    # Neither paper prints a stiffness: what stands in for it is named on the command line and on the page.
    assert setup.machine.origin and setup.machine.origin in setup.cautions[1]


def test_stiffness_along_the_contour():
    rows = [[0, 8000.0, 5000], [40.5, 900, 900]]
    assert from_dict(tables(machine__wall_over_height=rows)).machine.wall_over_height[1] == (40.5, 900, 900)
    with pytest.raises(FormatError, match="wall_over_height: height is 0 or more and ascends, 40.5 does not"):
        from_dict(tables(machine__wall_over_height=[rows[1], rows[1]]))
    assert from_dict(tables(machine__stiffness_along=rows)).machine.stiffness_along == (
        (0, 8000.0, 5000), (40.5, 900, 900),
    )  # fmt: skip
    for bad, says in (
        ([[0, 8000.0]], "is no row"), ([[0, 8.0, 0.8]], "above 1"), ([[5, 9e3, 9e3], [5, 9e3, 9e3]], "ascends"),
        ([[-1, 9e3, 9e3]], "0 or more"), ("table.csv", "is no row"), ([["0", 9e3, 9e3]], "is no row"),
    ):  # fmt: skip
        with pytest.raises(FormatError, match=says):
            from_dict(tables(machine__stiffness_along=bad))


def test_tilt_is_optional():
    assert from_dict(tables()).tilt is None
    tilt = from_dict(tables(tilt={"order": "BA", "b_sign": -1, "limit_deg": 3})).tilt
    assert tilt is not None and (tilt.order, tilt.a_sign, tilt.b_sign, tilt.limit_deg) == ("BA", 1, -1, 3.0)
    assert not tilt.tool_centre_point


def test_examples_are_there():
    assert len(list(SETUPS.glob("*.toml"))) >= 2


def test_specific_force_and_friction():
    """dat-2025, eqs. 5 and 6: the resultant is sqrt(1 + mu^2) Ks S."""
    changes = {"material__ktc_n_per_mm2": None, "material__krc_n_per_mm2": None}
    material = from_dict(tables(**changes, material__ks_n_per_mm2=1500, material__mu=0.4)).material
    assert (material.ktc_n_per_mm2, material.krc_n_per_mm2) == (1500.0, 600.0)
    assert (material.kte_n_per_mm, material.kre_n_per_mm) == (0.0, 0.0)
    assert (material.ktc_n_per_mm2**2 + material.krc_n_per_mm2**2) ** 0.5 == pytest.approx(1500 * 1.16**0.5)


BAD = [
    ({"machine__kx_n_per_mm": 0}, "[machine] kx_n_per_mm 0.0 is not above 1"),
    ({"machine__ky_n_per_mm": -5000.0}, "[machine] ky_n_per_mm"),
    ({"machine__kx_n_per_mm": float("nan")}, "[machine] kx_n_per_mm nan"),
    # 8 N/um written as if it were N/m.
    ({"machine__kx_n_per_mm": 8e7}, "[machine] kx_n_per_mm 80000000.0 is not above 1 and at most 1e+07 (N/mm"),
    ({"tool__overhang_mm": 4.0}, "[tool] overhang_mm 4 is shorter than the cut of 5 mm"),
    ({"tool__overhang_mm": 1000.0}, "[tool] overhang_mm 1000 is more than 40 diameters: is its unit mm?"),
    ({"tool__diameter_mm": 0.0}, "[tool] diameter_mm 0.0 is not above 0"),
    ({"tool__diameter_mm": float("nan")}, "[tool] diameter_mm nan"),
    ({"tool__diameter_mm": None}, "[tool] diameter_mm is missing"),
    ({"tool__diameter_mm": "10"}, "[tool] diameter_mm '10' is not a number"),
    ({"tool__flutes": 2.5}, "[tool] flutes 2.5 is not a whole number"),
    ({"tool__flutes": True}, "[tool] flutes True is not a whole number"),
    ({"tool__flutes": 0}, "[tool] flutes 0 is not at least 1"),
    ({"tool__helix_deg": 90.0}, "[tool] helix_deg 90.0"),
    ({"tool__youngs_modulus_gpa": 6e11}, "[tool] youngs_modulus_gpa 600000000000.0"),
    ({"tool__rotation": "left"}, "[tool] rotation 'left' is none of clockwise, anticlockwise"),
    ({"tool__effective_diameter_factor": 1.2}, "[tool] effective_diameter_factor 1.2"),
    ({"tool__radius_mm": 5.0}, "[tool] radius_mm is unknown"),
    ({"tool__diameter": 5.0}, "[tool] diameter is unknown: is it diameter_mm?"),
    ({"machine__kx_n_per_um": 8.0}, "[machine] kx_n_per_um is unknown: is it kx_n_per_mm?"),
    ({"material__ktc_n_per_mm2": None}, "[material] ktc_n_per_mm2 is missing"),
    ({"material__ktc_n_per_mm2": 2.0}, "[material] ktc_n_per_mm2 2.0 is not above 10"),
    ({"material__ktc_n_per_mm2": 2e9}, "[material] ktc_n_per_mm2 2000000000.0"),
    ({"material__ks_n_per_mm2": 2000.0}, "[material] mu is missing"),
    ({"material__ks_n_per_mm2": 2000.0, "material__mu": 0.3}, "[material] ktc_n_per_mm2 and ks_n_per_mm2 say the same"),
    ({"material__kte_n_per_mm": -1.0}, "[material] kte_n_per_mm -1.0"),
    ({"material__calibrated": "yes"}, "[material] calibrated 'yes' is not true or false"),
    ({"machine__acceleration_time_x_ms": -1.0}, "[machine] acceleration_time_x_ms"),
    ({"machine__position_gain_per_s": 0.0}, "[machine] position_gain_per_s"),
    ({"stock": {"axial_depth_mm": 5.0}}, "[stock] is missing"),
    ({"stock__solid": True}, "[stock] solid and allowance_mm say the same twice"),
    ({"stock__allowance_mm": -0.1}, "[stock] allowance_mm -0.1"),
    ({"stock__axial_depth_mm": None}, "[stock] top_z_mm or axial_depth_mm is needed"),
    ({"stock__top_z_mm": 0.0}, "[stock] top_z_mm or axial_depth_mm is needed"),
    ({"stock__program_tool_diameter_mm": 12.0}, "[stock] program_tool_diameter_mm goes with program"),
    (
        {"machine__acceleration_shape": "round"},
        "[machine] acceleration_shape 'round' is none of linear, bell, exponential",
    ),
    ({"machine__contour_control": True}, "[machine] contour_speed_change_mm_min is missing"),
    ({"machine__contour_speed_change_mm_min": 0.0}, "[machine] contour_speed_change_mm_min 0.0 is not above 0"),
    ({"tilt": {}}, "[tilt] order is missing"),
    ({"tilt": {"order": "C"}}, "[tilt] order 'C' is none of A, B, AB, BA"),
    ({"tilt": {"order": "B", "a_sign": 0}}, "[tilt] a_sign 0 is none of 1, -1"),
    ({"tilt": {"order": "B", "b_sign": "-"}}, "[tilt] b_sign '-' is not a whole number"),
    ({"tilt": {"order": "B", "limit_deg": 45}}, "[tilt] limit_deg 45.0 is not above 0 and at most 30"),
    ({"tilt": {"order": "B", "decimals": 7}}, "[tilt] decimals 7 is not at least 1 and at most 6"),
    ({"tilt": {"order": "B", "tool_centre_point": 1}}, "[tilt] tool_centre_point 1 is not true or false"),
    ({"tilt": {"order": "B", "limit": 2.0}}, "[tilt] limit is unknown: is it limit_deg?"),
    ({"tools": {}}, "[tools] is unknown: is it tool?"),
    ({"tool": 3}, "[tool] is a table"),
]


@pytest.mark.parametrize("changes, message", BAD, ids=[m.split(" is ")[0][:60] for _, m in BAD])
def test_bad_setups_name_the_key(changes, message, tmp_path):
    with pytest.raises(FormatError) as error:
        from_dict(tables(**changes), "job.toml")
    assert str(error.value).startswith(f"job.toml: {message}")
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("content", [b"\xff\xfe", b"[tool", b"", b"tool = 1"])
def test_files_that_are_no_setup(tmp_path, content):
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    with pytest.raises(FormatError, match=r"bad\.toml") as error:
        load(path)
    assert "\n" not in str(error.value)


def test_missing_file(tmp_path):
    with pytest.raises(FormatError, match=r"none\.toml"):
        load(tmp_path / "none.toml")


def test_paths_are_relative_to_the_file(tmp_path):
    text = "\n".join(
        f"[{name}]\n" + "\n".join(f"{k} = {v!r}".replace("True", "true") for k, v in table.items())
        for name, table in tables(stock={"program": "rough.nc", "axial_depth_mm": 5}).items()
    )
    (tmp_path / "job.toml").write_text(text)
    assert load(tmp_path / "job.toml").stock.program == tmp_path / "rough.nc"


@pytest.mark.parametrize("key", ["kx_n_per_mm", "ky_n_per_mm"])
def test_stiffness_is_asked_for_where_it_is_needed(key):
    setup = from_dict(tables(**{f"machine__{key}": None}))
    with pytest.raises(UsageError, match=rf"\[machine\] {key} is missing"):
        setup.machine.stiffness()
    assert issubclass(UsageError, MillcorrError)
