# SPDX-License-Identifier: LGPL-2.1-or-later
"""A correction in the order of its stages, each from frozen nouns to a frozen noun with its notes."""
