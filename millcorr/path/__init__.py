# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of a corrected program: laid, written, and proven by what is written."""
