# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool's deflection over the height of a wall, and its remedies (dat-2025)."""
