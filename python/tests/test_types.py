# SPDX-License-Identifier: Apache-2.0
"""Test type stubs against the package."""
import os
import pathlib
import subprocess
import sys

import pytest

import hawser


def test_stubtest_has_no_findings(tmp_path):
    pytest.importorskip("mypy")
    package = str(pathlib.Path(hawser.__file__).parents[1])
    done = subprocess.run([sys.executable, "-m", "mypy.stubtest", "hawser"], cwd=tmp_path,
                          capture_output=True, text=True,
                          env=os.environ | {"MYPYPATH": package, "PYTHONPATH": package})
    assert done.returncode == 0, done.stdout + done.stderr


def test_all_lazy_names_are_listed():
    assert set(hawser._LAZY) <= set(hawser.__all__)
