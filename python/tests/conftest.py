# SPDX-License-Identifier: Apache-2.0
"""Import the package of the build folder; tests of the compiled part are skipped without it."""
import importlib.util
import os
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("HAWSER_BUILD", ROOT / "build/release")).absolute()
sys.path.insert(0, str(BUILD / "python" if (BUILD / "python/hawser").is_dir() else ROOT / "python"))
COMPILED = importlib.util.find_spec("hawser._core") is not None

# Files that need numpy only.
NUMPY_ONLY = {"test_stats.py", "test_table.py"}


def pytest_ignore_collect(collection_path, config):
    """Skip files of the compiled part if it is missing."""
    name = collection_path.name
    return (not COMPILED and name.startswith("test_") and name not in NUMPY_ONLY) or None


@pytest.fixture(scope="session")
def scenes():
    """Return the folder of the shipped scenes."""
    return ROOT / "scenes"


@pytest.fixture(scope="session")
def program():
    """Return the program `hawser` of the build folder."""
    path = BUILD / "bin/hawser"
    if not path.exists():
        pytest.skip(f"{path} is not built")
    return str(path)


@pytest.fixture
def pendulum():
    """Return a world with a pendulum of 1 m."""
    import hawser

    world = hawser.World(step=1 / 60)
    world.add_body(name="ground", kind="fixed")
    world.add_body(name="bob", kind="lump", position=(1.0, 0.0, 0.0), mass=2.0)
    world.add_distance(name="rod", a="ground", b="bob")
    return world
