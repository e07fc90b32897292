# SPDX-License-Identifier: Apache-2.0
"""Test the command `hawser stats`: printed figures against hawser.stats, plots, errors."""
import math
import re

import numpy as np
import pytest

import hawser
from hawser import stats
from hawser.__main__ import main


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    """Return a table of a narrow-band process of 3 h and period 10 s, and its values."""
    rng, t = np.random.default_rng(8), np.arange(0.0, 10800.0, 0.5)
    omega = 2.0 * math.pi / 10.0 * np.linspace(0.9, 1.1, 300)
    x = sum(np.cos(w * t + p) for w, p in zip(omega, rng.uniform(0.0, 2.0 * math.pi, 300)))
    file = tmp_path_factory.mktemp("stats") / "run.csv"
    np.savetxt(file, np.column_stack([t, x, 0.0 * t + 3.0]), fmt="%.17g", delimiter=",",
               header="time [s],pull [N],depth [m]", comments="")
    return file, x


def numbers(text, pattern):
    """Return the numbers of the first match of a pattern, in which # is a number."""
    match = re.search(pattern.replace("#", r"([-+\d.e]+)"), text)
    assert match, f"{pattern}\n{text}"
    return [float(group) for group in match.groups()]


def test_figures_of_a_column(table, capsys):
    file, x = table
    assert main(["stats", str(file), "--column", "pull", "--hours", "1"]) == 0
    text = capsys.readouterr().out
    fit, cycles = stats.fit_peaks(x), 3600.0 / stats.up_crossing_period(x, 0.5)
    low, high = fit.interval(1.0 - 1.0 / cycles)
    assert numbers(text, r"Weibull, # peaks: location #, scale #, shape #") == \
        pytest.approx([fit.count, fit.location, fit.scale, fit.shape], rel=1e-3, abs=1e-4)
    assert numbers(text, r"most probable maximum in 1 h: #, 95 % interval # to #\n  Gumbel") == \
        pytest.approx([stats.most_probable_maximum(x, 0.5, 3600.0), low, high], rel=1e-4)
    blocks = stats.gumbel(x.reshape(20, -1).max(axis=1))
    mode = blocks.location + blocks.scale * math.log(3600.0 / 540.0)
    assert numbers(text, r"Gumbel, maxima of 20 blocks of 540 s: location #, scale #\n.* 1 h: #") \
        == pytest.approx([blocks.location, blocks.scale, mode], rel=1e-4)
    # Both estimates agree: sqrt(2 ln N) of a Rayleigh process.
    expected = x.std() * math.sqrt(2.0 * math.log(cycles))
    assert mode == pytest.approx(expected, rel=0.1)
    assert numbers(text, r"largest at # rad/s, # s")[1] == pytest.approx(10.0, rel=0.12)
    counts = [float(c) for c in re.findall(r" to +[\d.]+: ([\d.]+)", text)]
    assert sum(counts) == pytest.approx(stats.rainflow(x)[:, 2].sum())


def test_range_graphs_and_plots(table, scenes, tmp_path, capsys):
    pytest.importorskip("matplotlib")
    session = hawser.load(scenes / "hanging_chain.json", record=tmp_path / "run.hwr")
    session.run(0.5, progress=False)
    session.finish()
    assert main(["stats", str(tmp_path / "run.hwr"), "--range-graph", "--from", "0.1", "--plots",
                 str(tmp_path / "plots")]) == 0
    run = hawser.Recording(tmp_path / "run.hwr")
    name = run.cables[0]["name"]
    tension = run.tension(name)[run.time >= 0.1]
    rows = capsys.readouterr().out.split("maximum\n")[-1].split("\n")[:tension.shape[1]]
    printed = np.array([[float(v) for v in row.split()] for row in rows])
    assert printed[:, 1:] == pytest.approx(np.column_stack(stats.range_graph(tension)), rel=1e-4)
    assert main(["stats", str(table[0]), "--plots", str(tmp_path / "plots")]) == 0
    files = {file.name for file in (tmp_path / "plots").iterdir()}
    assert files == {f"range_{name}.png", "pull.png"}  # No plots of constant columns.


@pytest.mark.parametrize("options, words", [
    (["--column", "none"], "no column 'none'; there are: pull, depth"),
    (["--column", "depth"], "depth: 0 peaks"),
    (["--range-graph"], "give a recording"),
    (["--from", "1e9"], "fewer than two rows"),
])
def test_errors(table, capsys, options, words):
    assert main(["stats", str(table[0]), *options]) == 1
    assert words in capsys.readouterr().err
