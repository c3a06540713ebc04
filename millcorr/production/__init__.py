# SPDX-License-Identifier: LGPL-2.1-or-later
"""Serial production: journal, process control, trends."""
