# SPDX-License-Identifier: GPL-3.0-or-later
"""What testing/lab/charts.py is made of: tables, figures, the page."""
