# SPDX-License-Identifier: Apache-2.0
"""Hawser for Python: statistics of results.

`hawser.stats` works on numpy arrays, `hawser.table` reads tables that `hawser run --csv` wrote, and
`python3 -m hawser FILE.csv` prints the statistics of each column. Worlds and sessions are not bound
yet.
"""
from . import stats, table

__all__ = ["stats", "table"]
__version__ = "0.1.0"
