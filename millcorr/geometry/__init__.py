# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact plane curves, and nothing of milling."""
