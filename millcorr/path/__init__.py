# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path as it was written: a second reader of program text, and what it proves of it.

In come the bytes of a program and of its corrected copy, out go plain moves and a proof or a refusal. It shares
nothing with `millcorr.gcode`, which wrote the text.
"""
