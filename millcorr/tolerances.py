# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths below which two are the same: what everything that compares them agrees on. In mm.

What decides by a length that has a reason of its own, or by a share or a count, keeps it beside what decides;
docs/tolerances.md lists all of them.
"""

ARITHMETIC = 1e-9
"""Numbers that differ by less differ by arithmetic alone: a double holds 10 m to 2e-12 mm, and roots and sums of a few
thousand terms lose two."""

ALIKE = 1e-7
"""Corrections that differ by less are the same: a tenth of a nanometre, a thousandth of what any text states, and a
hundred times what solving for one leaves."""

EXACT = 1e-6
"""Lengths that differ by less than a nanometre are the same: the finest programs state 10 nm, no machine moves by one,
and what rounded ends leave of an arc, or a million increments of a place, is below."""
