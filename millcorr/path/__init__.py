# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of a corrected program: laid, written, and proven by what is written.

In come a program, its passes and a correction; out go moves, text and proof. The pipeline calls `emission`. What reads
the written text for the proof, `reading`, shares nothing with `millcorr.nc`, which wrote it.
"""
