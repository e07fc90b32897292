# SPDX-License-Identifier: Apache-2.0
"""Test batches: equal bits for any number of threads, branches, failures, checks of input."""
import numpy as np
import pytest

import hawser


def different_runs(scenes, threads):
    """Return hashes and outputs of worlds with different inputs."""
    with hawser.Batch(scenes / "crane_knuckle.json", 5, threads, inputs=["crane.slew"]) as batch:
        inputs = np.linspace(-0.05, 0.05, 5).reshape(5, 1)
        outputs = [batch.step(10, inputs * k) for k in range(3)]
        return batch.hashes, np.array(outputs)


def test_bits_do_not_depend_on_threads(scenes):
    hashes, outputs = different_runs(scenes, 1)
    assert len(set(hashes.tolist())) == 5
    for threads in (2, 3):
        again, same = different_runs(scenes, threads)
        assert np.array_equal(hashes, again) and np.array_equal(outputs, same, equal_nan=True)


def test_branches_equal_the_parent(scenes):
    parent = hawser.load(scenes / "crane_knuckle.json")
    parent.step(15)
    state = parent.save()
    parent.step()
    with hawser.Batch(scenes / "crane_knuckle.json", 4, 2) as batch:
        for _ in range(3):
            batch.restore(state)
            batch.step()
            assert set(batch.hashes.tolist()) == {parent.world.state_hash}


@pytest.mark.parametrize("inputs, words", [
    (np.zeros((4, 1)), r"\(5, 1\).*float64.*\(4, 1\)"),
    (np.zeros((5, 1), complex), "float64.*complex128"),
    (np.full((5, 1), np.nan), "NaN"),
])
def test_inputs_are_checked(scenes, inputs, words):
    with hawser.Batch(scenes / "crane_knuckle.json", 5, inputs=["crane.slew"]) as batch:
        with pytest.raises(ValueError, match=words):
            batch.step(1, inputs)
        assert (batch.time == 0.0).all()


def test_a_failed_world_is_left_out(scenes):
    with hawser.Batch(scenes / "crane_knuckle.json", 3, 2) as batch:
        batch.step(5)
        state = batch.save()
        batch.sessions[1].world.cancel()
        outputs = batch.step(5)
        assert batch.failed.tolist() == [False, True, False]
        assert isinstance(batch.errors[1], hawser.StepError)
        assert np.isnan(outputs[1]).all()
        assert batch.time[0] > batch.time[1]
        batch.restore(state)
        assert not batch.failed.any()
        batch.step(5)
        assert len(set(batch.hashes.tolist())) == 1


def test_names_are_checked(scenes):
    with pytest.raises(hawser.DefError):
        hawser.Batch(scenes / "crane_knuckle.json", 2, inputs=["none"])
    with pytest.raises(ValueError, match=">= 1"):
        hawser.Batch(scenes / "crane_knuckle.json", 0)
