# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a dressup's view that say what its picture shows."""

from __future__ import annotations

from millcorr.app.properties import QT_TRANSLATE_NOOP, Property

_text = QT_TRANSLATE_NOOP

PROPERTIES = (
    Property("Bool", "ShowPicture", "Picture", _text("App::Property", "Show the deviations in the 3-D view"), False),
    Property(
        "Bool",
        "AutomaticMagnification",
        "Picture",
        _text("App::Property", "Deviations and the part's size decide how much larger deviations are drawn"),
        True,
    ),
    Property(
        "Float",
        "Magnification",
        "Picture",
        _text(
            "App::Property",
            "So many times longer than they are deviations and differences are drawn, as far as it turns no contour "
            "inside out",
        ),
        500.0,
    ),
    Property(
        "Distance",
        "UpperLimit",
        "Picture",
        _text("App::Property", "Larger deviations are out of tolerance: too much material is left"),
        0.01,
    ),
    Property(
        "Distance",
        "LowerLimit",
        "Picture",
        _text("App::Property", "Smaller deviations are out of tolerance: too much is cut away"),
        -0.01,
    ),
    Property(
        "Enumeration",
        "MaterialLeft",
        "Picture",
        _text("App::Property", "Colour of material left; measuring machines' programs show it red"),
        ("blue", "red"),
    ),
    Property(
        "Bool", "Wall", "Picture", _text("App::Property", "Show the deviation as the colour of the wall itself"), True
    ),
    Property("Bool", "Whiskers", "Picture", _text("App::Property", "Show each deviation as a line"), True),
    Property("Bool", "Band", "Picture", _text("App::Property", "Show the tolerance band"), True),
    Property("Bool", "Profiles", "Picture", _text("App::Property", "Show nominal and compensated profile"), True),
    Property("Bool", "Paths", "Picture", _text("App::Property", "Show the path before and after"), True),
    Property("Bool", "RejectedPoints", "Picture", _text("App::Property", "Mark points that are left out"), True),
    Property("Bool", "Legend", "Picture", _text("App::Property", "Show what the colours mean"), True),
)
"""Properties of the dressup's view: how it is shown, never what is corrected."""
