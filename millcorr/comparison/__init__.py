# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the passes of a program leave, and how far measured points are off it."""
