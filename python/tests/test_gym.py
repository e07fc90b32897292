# SPDX-License-Identifier: Apache-2.0
"""Test environments: protocol, equal episodes for equal seeds, controllers better than none."""
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import hawser
from hawser import gym


def episode(env, controller, seconds, seed):
    """Return the sum of rewards and the observations."""
    x, _ = env.reset(seed=seed)
    total, seen = 0.0, [x]
    for _ in range(round(seconds / env.period)):
        x, reward, terminated, truncated, _ = env.step(controller(x))
        total += reward
        seen.append(x)
        if terminated or truncated:
            break
    return total, np.array(seen)


def hold(x):
    """Pay out if the tension is above its target."""
    return [np.clip(1.5 * x[0], -1.0, 1.0)]


def slew(x):
    """Slew to the angle; the tip follows the hook, which damps the swing."""
    return [np.clip(5.0 * x[0] + 0.7 * x[3], -1.0, 1.0)]


def station(x):
    """PD control of three axes."""
    return np.clip([-0.05 * x[0] - 0.8 * x[3], -0.05 * x[1] - 0.8 * x[4],
                    -2.0 * x[2] - 60.0 * x[5]], -1.0, 1.0)


CASES = [(gym.TowTension, "tow_payout", hold, 40.0), (gym.AntiSway, "crane_knuckle", slew, 40.0),
         (gym.StationKeeping, "dp_ship", station, 120.0)]


@pytest.mark.parametrize("kind, scene, controller, seconds", CASES)
def test_environments(scenes, kind, scene, controller, seconds):
    env = kind(scenes / f"{scene}.json")
    x, info = env.reset(seed=5)
    assert env.observation_space.contains(x) and x.shape == env.observation_space.shape
    assert "time" in info and env.action_space.contains(env.action_space.sample())
    controlled, first = episode(env, controller, seconds, 7)
    again, second = episode(env, controller, seconds, 7)
    assert controlled == again and np.array_equal(first, second)
    free, _ = episode(env, lambda _: np.zeros(env.action_space.shape), seconds, 7)
    assert controlled > free
    other, _ = episode(env, controller, 5.0, 8)
    assert other != episode(env, controller, 5.0, 9)[0]


def test_swing_is_damped(scenes):
    env = gym.AntiSway(scenes / "crane_knuckle.json")
    _, seen = episode(env, slew, 60.0, 3)
    assert abs(seen[-1][0]) < 0.01 and np.hypot(seen[-1][2], seen[-1][3]) < 0.1
    bang = episode(env, lambda x: [np.sign(x[0]) * (abs(x[0]) > 0.01)], 60.0, 3)[1]
    assert np.hypot(bang[:, 2], bang[:, 3]).max() > np.hypot(seen[:, 2], seen[:, 3]).max()


def test_bad_actions(scenes):
    env = gym.AntiSway(scenes / "crane_knuckle.json", duration=0.3)
    env.reset(seed=1)
    for action in ([0.0, 0.0], [np.nan], 0.5):
        with pytest.raises(ValueError, match="action"):
            env.step(action)
    assert [env.step([2.0])[3] for _ in range(3)] == [False, False, True]
    assert env.session.inputs["crane.slew"] == 0.06  # limited
    with pytest.raises(ValueError, match="period"):
        gym.AntiSway(scenes / "crane_knuckle.json", period=0.0)
    _, info = env.reset(options={"target": 0.25})
    assert env.target == 0.25 and info["time"] < 0.02


def test_environments_subclass_gymnasium_if_it_is_installed(scenes, tmp_path):
    """A stand-in for the package has the names that hawser.gym uses."""
    (tmp_path / "gymnasium").mkdir()
    (tmp_path / "gymnasium/__init__.py").write_text("class Env:\n    pass\n")
    (tmp_path / "gymnasium/spaces.py").write_text(
        "class Box:\n    def __init__(self, low, high, shape, dtype):\n        self.shape = shape\n")
    code = ("import gymnasium, gymnasium.spaces, sys; from hawser import gym\n"
            "env = gym.AntiSway(sys.argv[1]); x, info = env.reset(seed=1)\n"
            "assert isinstance(env, gymnasium.Env) and len(env.step([0.1])) == 5\n"
            "assert isinstance(env.observation_space, gymnasium.spaces.Box)\n")
    package = str(pathlib.Path(hawser.__file__).parents[1])
    done = subprocess.run([sys.executable, "-c", code, str(scenes / "crane_knuckle.json")],
                          env=os.environ | {"PYTHONPATH": f"{package}:{tmp_path}"},
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
