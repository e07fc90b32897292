# SPDX-License-Identifier: Apache-2.0
"""Test recordings as arrays and data sets, against the run that wrote them."""
import json
import subprocess

import numpy as np
import pytest

import hawser
from hawser import stats, table

from conftest import ROOT


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Return a recording of a hanging chain in waves, with values of the run itself."""
    file = tmp_path_factory.mktemp("run") / "run.hwr"
    scene = json.loads((ROOT / "scenes/hanging_chain.json").read_text())
    scene["line_types"]["chain"] |= {"diameter": 0.03, "cd_normal": 2.0, "ca_normal": 1.0}
    scene["sea"] = {"depth": 60, "waves": [{"kind": "regular", "height": 2.0, "period": 5.0}]}
    session = hawser.load(text=json.dumps(scene))
    session.record(file, every=2)
    time, position, tension = [], [], []
    cable = session.cables[0]
    for _ in range(1200):  # one period
        session.step()
        if session.world.step_count % 2 == 0:
            time.append(session.time)
            position.append(session.world.position.copy())
            tension.append([-e.force[0] for e in cable["elements"]])
    session.finish()
    return (hawser.Recording(file), cable["name"], np.array(time), np.array(position),
            np.array(tension))


def test_frames_equal_the_run(run):
    recording, name, time, position, tension = run
    assert recording.ending == "finished" and recording.damage == ""
    assert recording.every == 2 and len(recording) == 601
    assert np.allclose(recording.time[1:], time, atol=1e-12)
    # Frames have single precision: 6e-8 of a coordinate.
    assert np.allclose(recording.position()[1:], position, rtol=1e-6, atol=1e-6)
    scale = np.abs(tension).max()
    assert np.allclose(recording.tension(name)[1:], tension, rtol=1e-6, atol=1e-6 * scale)


@pytest.mark.parametrize("every", [1, 7])
def test_outputs_and_signals_equal_the_run(scenes, tmp_path, every):
    session = hawser.load(scenes / "tow_payout.json", record=tmp_path / "run.hwr", every=every)
    names, seen = list(session.outputs), []
    assert "winch.pull" in session.world.signals and "winch.pull" in names
    session.inputs["winch.speed"] = 0.5
    for _ in range(42):
        session.step()
        if session.world.step_count % every == 0:
            seen.append(session.outputs.values_array)
    session.finish()
    recording = hawser.Recording(tmp_path / "run.hwr")
    assert recording.output_names == names
    assert recording.output_units == [session.outputs.unit(n) for n in names]
    recorded = np.column_stack([recording.output(n) for n in names])
    assert np.array_equal(recorded[1:], np.array(seen), equal_nan=True)
    assert len(seen) == 42 // every and np.ptp(recording.output("winch.pull")[1:]) > 0.0
    with pytest.raises(KeyError, match="no output.*known"):
        recording.output("none")


def test_outputs_in_recordings_of_the_program(scenes, program, tmp_path):
    """The table of the program has the same outputs, with nine digits."""
    done = subprocess.run([program, "run", str(scenes / "moored_barge.json"), "--duration", "2",
                           "--quiet", "--record", str(tmp_path / "run.hwr"), "--record-every", "6",
                           "--csv", str(tmp_path / "run.csv")], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    recording, data = hawser.Recording(tmp_path / "run.hwr"), table.read(tmp_path / "run.csv")
    assert recording.output_names
    for name, unit in zip(recording.output_names, recording.output_units):
        assert data[name].unit == unit
        assert np.allclose(recording.output(name)[1:], data[name].values, rtol=1e-8, atol=0.0,
                           equal_nan=True)
    xarray = pytest.importorskip("xarray")
    assert isinstance(recording.to_xarray()[name], xarray.DataArray)
    assert recording.to_xarray()[name].attrs["units"] == unit
    done = subprocess.run([program, "stats", str(tmp_path / "run.hwr")], capture_output=True,
                          text=True)
    assert f"{recording.output_names[0]} [" in done.stdout, done.stdout + done.stderr


def test_range_graph_equals_the_extremes(run):
    recording, name, _, position, tension = run
    low, mean, high = stats.range_graph(recording.tension(name)[1:])
    assert np.ptp(tension, axis=0).min() > 0.1 and np.ptp(position[:, :, 0]) > 0.5  # It moves.
    scale = 1e-6 * np.abs(tension).max()
    assert np.allclose(low, tension.min(axis=0), atol=scale)
    assert np.allclose(high, tension.max(axis=0), atol=scale)
    assert np.allclose(mean, tension.mean(axis=0), atol=scale)
    assert len(recording.arc_length(name)) == tension.shape[1]


def test_data_set_has_units_and_names(run):
    pytest.importorskip("xarray")
    recording, name, time, position, _ = run
    data = recording.to_xarray()
    assert data.position.attrs["units"] == "m"
    assert data[f"tension_{name}"].attrs["units"] == "N"
    body = recording.body_names[1]
    assert np.allclose(data.position.sel(body=body or "body 1")[1:], position[:, 1], rtol=1e-6,
                       atol=1e-6)
    assert data.attrs["scene"] == "hanging_chain"


def test_unknown_names(run):
    recording = run[0]
    with pytest.raises(KeyError, match="no body"):
        recording.position("nobody")
    with pytest.raises(KeyError, match="known"):
        recording.tension("none")


def test_damaged_file(run, tmp_path):
    data = open(run[0].file, "rb").read()
    (tmp_path / "cut.hwr").write_bytes(data[:len(data) * 2 // 3])
    part = hawser.Recording(tmp_path / "cut.hwr")
    assert part.ending == "unknown" and part.damage
    assert np.array_equal(part.position(), run[0].position()[:len(part)])
    (tmp_path / "no.hwr").write_bytes(b"HAWSERRC" + bytes(100))
    with pytest.raises(hawser.RecordingError, match="no.hwr"):
        hawser.Recording(tmp_path / "no.hwr")
