# SPDX-License-Identifier: Apache-2.0
"""Execute the Python code of the documentation and the examples in docstrings."""
import doctest
import importlib
import re
import shutil

import pytest

from conftest import ROOT

PAGES = ["README.md", "docs/python.md", "docs/studies.md"]


def blocks(page):
    """Return the Python code of a page, one text, since later blocks use names of earlier ones."""
    text = (ROOT / page).read_text(encoding="utf-8")
    return "\n".join(re.findall(r"```python\n(.*?)```", text, re.DOTALL))


@pytest.mark.parametrize("page", PAGES)
def test_code_of_pages(page, tmp_path, monkeypatch):
    code = blocks(page)
    assert "import hawser" in code
    shutil.copytree(ROOT / "scenes", tmp_path / "scenes")
    monkeypatch.chdir(tmp_path)
    exec(compile(code, page, "exec"), {"__name__": "page"})  # noqa: S102


@pytest.mark.parametrize("module", ["hawser", "hawser.session", "hawser.stats", "hawser.batch"])
def test_examples_of_docstrings(module, monkeypatch):
    monkeypatch.chdir(ROOT)
    done = doctest.testmod(importlib.import_module(module))
    assert done.failed == 0
