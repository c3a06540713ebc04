# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of messages that can be read in a light and in a dark window."""

from __future__ import annotations

_KINDS = {"wrong": "220, 40, 40", "doubt": "230, 160, 0", "good": "40, 160, 80"}

_LABEL = "background: rgba({0}, 50); border-left: 3px solid rgb({0}); padding: 3px 3px 3px 8px;"

STYLE = "\n".join(f'QLabel[millcorr="{kind}"] {{ {_LABEL.format(rgb)} }}' for kind, rgb in _KINDS.items())
"""Style sheet for labels whose property ``millcorr`` says what they are.

The text keeps the window's own colour: style sheets change it without the palette telling, so a tint that lets
the window's background through is all that can be read in both.
"""
