# SPDX-License-Identifier: LGPL-2.1-or-later
"""From arguments and file names to files written whole."""
