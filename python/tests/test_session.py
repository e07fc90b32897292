# SPDX-License-Identifier: Apache-2.0
"""Test runs of scenes: hashes against the program, states, recordings, inputs."""
import copy
import gc
import json
import os
import pathlib
import pickle
import subprocess
import sys

import pytest

import hawser

from conftest import ROOT

STEPS = 100
# Files of states that scenes include are no scenes.
SCENES = sorted(file.stem for file in (ROOT / "scenes").glob("*.json")
                if not file.stem.endswith(".settled"))


def program_hash(program, scene, steps, tmp_path):
    """Return the state hash of the program after a number of steps."""
    step = hawser.load(scene).world.settings["step"]
    summary = tmp_path / "summary.json"
    subprocess.run([program, "run", str(scene), "--duration", repr(steps * step), "--quiet",
                    "--summary", str(summary)], check=False, capture_output=True)
    return json.loads(summary.read_text())


def find_key(data, key):
    """Return the value of a key at any depth."""
    if isinstance(data, dict):
        if key in data:
            return data[key]
        data = list(data.values())
    if isinstance(data, list):
        for entry in data:
            found = find_key(entry, key)
            if found is not None:
                return found
    return None


@pytest.fixture(scope="module")
def hashes_of_cpp(scenes, program):
    """Return the state hash of each scene after STEPS steps in a C++ program."""
    done = subprocess.run([str(pathlib.Path(program).with_name("hawser_state_hash")), str(STEPS),
                           *[str(scenes / f"{name}.json") for name in SCENES]],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    rows = [line.split() for line in done.stdout.splitlines()]
    assert [steps for _, steps, _ in rows] == [str(STEPS)] * len(SCENES)
    return {name: state for name, _, state in rows}


@pytest.mark.parametrize("name", SCENES)
def test_program_and_cpp_have_the_same_hash(name, scenes, program, hashes_of_cpp, tmp_path):
    scene = scenes / f"{name}.json"
    summary = program_hash(program, scene, STEPS, tmp_path)
    session = hawser.load(scene, threads=2)
    session.step(STEPS)
    assert find_key(summary, "steps") == STEPS
    assert f"{session.world.state_hash:016x}" == find_key(summary, "state_hash")
    assert f"{session.world.state_hash:016x}" == hashes_of_cpp[name]


def test_a_session_is_freed_without_garbage_collection(scenes):
    gc.collect()
    gc.disable()
    try:
        session = hawser.load(scenes / "pendulum.json")
        session.run(0.1, callback=lambda s: s.inputs and s.outputs, progress=False)
        body = session.world.body("bob")
        del session
        with pytest.raises(hawser.RemovedError, match="does not exist"):
            print(body.position)
    finally:
        gc.enable()


def test_set_changes_the_scene(scenes):
    session = hawser.load(scenes / "pendulum.json", set={"settings.step": 0.01})
    assert session.world.settings["step"] == 0.01
    session.step(100)
    assert session.time == pytest.approx(1.0, abs=1e-12)


def test_invalid_scene_has_a_position(scenes):
    with pytest.raises(hawser.SceneError) as error:
        hawser.load(text='{"format": "hawser-scene", "version": 1, "bodies": [{"mas": 3}]}')
    assert error.value.path.startswith("/")
    assert pickle.loads(pickle.dumps(error.value)).path == error.value.path


def test_load_needs_one_scene():
    with pytest.raises(ValueError, match="file or a text"):
        hawser.load()


@pytest.fixture
def hook(scenes):
    return hawser.load(scenes / "crane_knuckle.json")


def test_inputs_and_outputs(hook):
    name = next(iter(hook.inputs))
    before = hook.inputs[name]
    assert isinstance(before, float)
    with pytest.raises(hawser.DefError, match="nearest"):
        hook.inputs[name + "x"] = 1.0
    with pytest.raises(ValueError, match="NaN"):
        hook.inputs[name] = float("nan")
    hook.step(2)
    assert len(hook.outputs) == len(hook.outputs.values_array)
    for output, value in hook.outputs.items():
        assert value == hook.world.output(output).value


def test_inputs_change_the_run(hook):
    other = copy.deepcopy(hook)
    hook.inputs["crane.slew"] = 0.05
    hook.step(60)
    other.step(60)
    assert hook.world.state_hash != other.world.state_hash


def test_restore_repeats_the_steps(hook):
    hook.step(20)
    state = hook.save()
    hook.step(30)
    after = hook.world.state_hash
    hook.restore(state)
    assert hook.time == pytest.approx(state.time)
    hook.step(30)
    assert hook.world.state_hash == after


def test_copy_continues_with_equal_bits(hook):
    hook.step(20)
    other = copy.deepcopy(hook)
    hook.step(25)
    other.step(25)
    assert other.world.state_hash == hook.world.state_hash


def test_pickle_continues_in_another_process(hook, tmp_path):
    hook.step(20)
    (tmp_path / "session").write_bytes(pickle.dumps(hook))
    hook.step(25)
    code = ("import pickle, sys; s = pickle.load(open(sys.argv[1], 'rb')); s.step(25); "
            "print(s.world.state_hash)")
    package = os.path.dirname(os.path.dirname(os.path.abspath(hawser.__file__)))
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path / "session")], check=True,
                          capture_output=True, text=True,
                          env=dict(os.environ, PYTHONPATH=package))
    assert int(done.stdout) == hook.world.state_hash


def test_saved_file_restores(hook, scenes, tmp_path):
    hook.step(10)
    hook.save(tmp_path / "state")
    hook.step(10)
    other = hawser.load(scenes / "crane_knuckle.json", restore=tmp_path / "state")
    other.step(10)
    assert other.world.state_hash == hook.world.state_hash
    hook.restore(tmp_path / "state")
    hook.step(10)
    assert other.world.state_hash == hook.world.state_hash


def test_payout_state_has_its_nodes(scenes):
    """A winch inserts nodes: a state then has another structure than the scene."""
    session = hawser.load(scenes / "tow_payout.json")
    session.step(600)
    state, other = session.save(), copy.deepcopy(session)
    pickled = pickle.loads(pickle.dumps(session))
    session.step(50)
    after = session.world.state_hash
    for one in (other, pickled):
        one.step(50)
        assert one.world.state_hash == after
    session.restore(state)
    session.step(50)
    assert session.world.state_hash == after


def test_program_replays_a_recording_of_python(hook, program, tmp_path):
    file = tmp_path / "run.hwr"
    hook.record(file, every=5)
    hook.inputs["crane.slew"] = 0.05
    hook.step(40)
    state = hook.save()
    hook.world.body("crane/hook").set_force((100.0, 0.0, 0.0))
    hook.step(20)
    hook.restore(state)
    hook.step(20)
    assert hook.finish() == "finished"
    done = subprocess.run([program, "replay", str(file)], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_run_calls_back_and_ends(scenes):
    session = hawser.load(scenes / "pendulum.json", set={"settings.step": 0.01})
    times = []
    session.run(until=1.0, every=0.1, callback=lambda s: times.append(s.time))
    assert times == pytest.approx([0.1 * i for i in range(1, 11)])
    session.run(until=2.0, every=0.25, callback=lambda s: s.time < 1.4)
    assert session.time == pytest.approx(1.5)
    with pytest.raises(ValueError, match="above 0"):
        session.run(every=0.0)


def test_events_of_a_step(scenes):
    session = hawser.load(scenes / "crane_knuckle.json")
    session.set_input("crane.slew", 1e9)
    session.step()
    kinds = [e.kind for e in session.events]
    assert "input_clamped" in kinds


def test_unknown_option_names_the_nearest():
    with pytest.raises(TypeError):
        hawser.load("scenes/pendulum.json", thread=2)
