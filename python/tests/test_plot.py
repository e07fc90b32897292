# SPDX-License-Identifier: Apache-2.0
"""Test plots: drawn data equal the results."""
import numpy as np
import pytest

import hawser
from hawser import table

pyplot = pytest.importorskip("matplotlib.pyplot")
pyplot.switch_backend("Agg")
from hawser import plot  # noqa: E402


@pytest.fixture
def run(scenes, tmp_path):
    """Return a recording of the moored barge."""
    session = hawser.load(scenes / "moored_barge.json", record=tmp_path / "run.hwr",
                          csv=tmp_path / "run.csv")
    session.run(3.0, progress=False)
    session.finish()
    return hawser.Recording(tmp_path / "run.hwr")


def test_plots_show_the_results(run, tmp_path):
    name = run.cables[0]["name"]
    axes = plot.range_graph(run, name)
    mean = axes.lines[0].get_ydata()
    assert np.allclose(mean, run.tension(name).mean(axis=0) / 1e3)
    assert len(axes.lines[0].get_xdata()) == run.cables[0]["elements"]
    lines = plot.tensions(run, [name]).lines
    assert np.allclose(lines[0].get_ydata(), run.tension(name).max(axis=1) / 1e3)
    data = table.read(tmp_path / "run.csv")
    drawn = plot.series(data, ["north_east_tension"]).lines[0]
    assert np.array_equal(drawn.get_ydata(), data["north_east_tension"].values)
    with pytest.raises(ValueError, match="one unit"):
        plot.series(data, ["north_east_tension", "surge"])
    pyplot.close("all")


def test_statistics_plots():
    t = np.arange(0.0, 200.0, 0.1)
    x = np.sin(1.5 * t)
    line = plot.spectrum(x, 0.1).lines[0]
    assert abs(line.get_xdata()[np.argmax(line.get_ydata())] - 1.5) < 0.1
    bars = plot.rainflow(x, bins=10).patches
    assert bars[-1].get_height() > 0.9 * sum(b.get_height() for b in bars)  # full ranges
    pyplot.close("all")
