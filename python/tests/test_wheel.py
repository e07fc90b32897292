# SPDX-License-Identifier: Apache-2.0
"""Test the wheel in a fresh virtual environment, outside the checkout."""
import os
import re
import shutil
import subprocess
import sys

import pytest

from conftest import BUILD, ROOT


def test_wheel_runs_the_example_of_the_readme(tmp_path, program):
    for module in ("setuptools", "wheel", "venv"):
        pytest.importorskip(module)
    environment = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "HAWSER_PROGRAM")}

    def run(*command):
        done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    wheel = run(str(ROOT / "scripts/make_wheel.sh"), str(BUILD)).strip()
    run(sys.executable, "-m", "venv", "--system-site-packages", "env")
    python = str(tmp_path / "env/bin/python")
    run(python, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", wheel)
    example = re.search(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)[1]
    shutil.copytree(ROOT / "scenes", tmp_path / "scenes")
    (tmp_path / "example.py").write_text(
        example + "\nprint(hawser.__file__, len(session.picture()) > 1000)\n")
    printed = run(python, "example.py").split("\n")
    assert printed[0].startswith("2.0 [")
    assert printed[1].startswith(str(tmp_path / "env")) and printed[1].endswith("True")
