# SPDX-License-Identifier: Apache-2.0
"""Test recordings as arrays and data sets, against the run that wrote them."""
import numpy as np
import pytest

import hawser
from hawser import stats


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Return a recording of a hanging chain that is pushed, with values of the run itself."""
    from conftest import ROOT

    file = tmp_path_factory.mktemp("run") / "run.hwr"
    session = hawser.load(ROOT / "scenes/hanging_chain.json")
    session.record(file, every=2)
    time, position, tension = [], [], []
    cable = session.cables[0]
    push = cable["nodes"][-2]
    push.set_force((200.0, 0.0, 0.0))
    for step in range(60):
        session.step()
        if step == 30:
            push.set_force((0.0, 0.0, 0.0))
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
    assert recording.every == 2 and len(recording) == 31
    assert np.allclose(recording.time[1:], time, atol=1e-12)
    # Frames have single precision: 6e-8 of a coordinate.
    assert np.allclose(recording.position()[1:], position, rtol=1e-6, atol=1e-6)
    scale = np.abs(tension).max()
    assert np.allclose(recording.tension(name)[1:], tension, rtol=1e-6, atol=1e-6 * scale)


def test_range_graph_equals_the_extremes(run):
    recording, name, *_, tension = run
    low, mean, high = stats.range_graph(recording.tension(name)[1:])
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
