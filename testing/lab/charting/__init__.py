# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of testing/lab/charts.py: tables, figures, the page."""
