# SPDX-License-Identifier: Apache-2.0
"""Environments in the protocol of Gymnasium, for control and reinforcement learning.

>>> from hawser import gym
>>> env = gym.AntiSway("scenes/crane_knuckle.json")
>>> observation, info = env.reset(seed=1)
>>> observation, reward, terminated, truncated, info = env.step([0.5])
>>> env.observation_space.contains(observation), terminated
(True, False)

Environments work without the package `gymnasium`; they subclass `gymnasium.Env` if it is installed.
A seed determines the whole episode, bit for bit. Actions are between -1 and 1.
"""
from __future__ import annotations

import math
import os
from collections import abc
from typing import Any

import numpy as np

from .errors import StepError
from .session import Session, load

__all__ = ["SceneEnv", "TowTension", "AntiSway", "StationKeeping", "Box"]


class _OwnEnv:
    """Base class without gymnasium."""

    metadata: dict[str, Any] = {"render_modes": []}
    render_mode = None

    @property
    def unwrapped(self) -> Any:
        """This environment."""
        return self

    def close(self) -> None:
        """Release the world."""

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *args: object) -> None:
        self.close()


class _OwnBox:
    """Box of numbers between low and high, as in gymnasium.spaces."""

    def __init__(self, low: Any, high: Any, shape: tuple[int, ...] | None = None,
                 dtype: Any = np.float32) -> None:
        self.dtype = np.dtype(dtype)
        self.shape = tuple(shape) if shape is not None else np.shape(low)
        self.low = np.full(self.shape, low, self.dtype)
        self.high = np.full(self.shape, high, self.dtype)
        self._random = np.random.default_rng()

    def seed(self, seed: int | None = None) -> None:
        """Seed the random numbers of `sample`."""
        self._random = np.random.default_rng(seed)

    def sample(self) -> np.ndarray:
        """Return a random point; unbounded entries are normally distributed."""
        bounded = np.isfinite(self.low) & np.isfinite(self.high)
        low, high = np.where(bounded, self.low, 0.0), np.where(bounded, self.high, 1.0)
        x = np.where(bounded, self._random.uniform(low, high),
                     self._random.normal(size=self.shape))
        return x.astype(self.dtype)

    def contains(self, x: Any) -> bool:
        """True if x has the shape and lies in the box."""
        x = np.asarray(x)
        return x.shape == self.shape and bool(np.all((x >= self.low) & (x <= self.high)))

    def __repr__(self) -> str:
        return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"


def _classes() -> tuple[Any, Any]:
    """Return the classes Env and Box of gymnasium if it is installed, else those of this module."""
    try:
        from gymnasium import Env  # type: ignore
        from gymnasium.spaces import Box as GymBox  # type: ignore
    except ImportError:
        return _OwnEnv, _OwnBox
    return Env, GymBox


_Env: Any
Box: Any
_Env, Box = _classes()


class SceneEnv(_Env):
    """Environment on a scene; subclasses define observation, reward and end.

    Parameters
    ----------
    scene : path
        Scene file.
    actions : mapping
        Amplitude of each input: an action a in [-1, 1] sets the input to a times it.
    size : int
        Number of observed values.
    period : float
        Time between actions [s], a multiple of the step.
    duration : float
        Time after which an episode is truncated [s].
    set : mapping, optional
        Changes to the scene.
    threads : int
        Worker threads; results do not depend on it.
    """

    def __init__(self, scene: str | os.PathLike[str], actions: abc.Mapping[str, float], size: int, *,
                 period: float = 0.1, duration: float = 60.0, set: abc.Mapping[str, Any] | None = None,
                 threads: int = 1) -> None:
        if not 0.0 < period <= duration:
            raise ValueError(f"period and duration: give 0 < period <= duration, not {period} and "
                             f"{duration}")
        self.session: Session = load(scene, set=set, threads=threads)
        step = self.session.world.settings["step"]
        self.steps = max(1, round(period / step))
        self.period = self.steps * step  #: Time between actions [s].
        self.duration = duration
        self._amplitudes = dict(actions)
        for name in self._amplitudes:
            self.session.inputs[name] = self.session.inputs[name]  # Refuses an unknown name.
        self._start = self.session.save()
        self._begun = 0.0
        self.random = np.random.default_rng()  #: Random numbers of the episode.
        count = len(self._amplitudes)
        self.action_space = Box(-1.0, 1.0, (count,), np.float32)
        self.observation_space = Box(-np.inf, np.inf, (size,), np.float64)

    # --- For subclasses -------------------------------------------------------------------------
    def begin(self, options: abc.Mapping[str, Any]) -> None:
        """Draw the task of an episode from `self.random`. Called after the start is restored."""

    def measure(self) -> None:
        """Update values that observe(), reward() and ended() share. Called after each period."""

    def observe(self) -> np.ndarray:
        """Return the observed values."""
        raise NotImplementedError

    def reward(self, action: np.ndarray) -> float:
        """Return the reward of the last period."""
        raise NotImplementedError

    def ended(self) -> bool:
        """True if the task failed or is complete."""
        return False

    # --- Protocol -------------------------------------------------------------------------------
    def reset(self, *, seed: int | None = None,
              options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Start an episode.

        Parameters
        ----------
        seed : int, optional
            Determines the episode; None continues the random numbers.
        options : dict, optional
            Values of the task, which replace drawn ones.
        """
        if seed is not None:
            self.random = np.random.default_rng(seed)
        if self._start is not None:
            self.session.restore(self._start)
        self._begun = self.session.time
        self.begin(options or {})
        return self.observe(), self.info()

    def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Apply an action for one period.

        Values beyond [-1, 1] are limited.

        Raises
        ------
        ValueError
            For another shape, or values that are not finite.
        """
        a = np.asarray(action, dtype=float)
        if a.shape != self.action_space.shape or not np.all(np.isfinite(a)):
            raise ValueError(f"action: give {self.action_space.shape[0]} finite numbers; shape "
                             f"{a.shape}, {a}")
        a = np.clip(a, -1.0, 1.0)
        for (name, amplitude), value in zip(self._amplitudes.items(), a):
            self.session.inputs[name] = float(value) * amplitude
        info: dict[str, Any] = {}
        failed = False
        try:
            self.session.step(self.steps)
        except StepError as error:
            failed = True
            info["error"] = str(error)
        self.measure()
        observation = self.observe()
        truncated = self.session.time - self._begun >= self.duration - 1e-9
        return (observation, self.reward(a), bool(failed or self.ended()), bool(truncated),
                info | self.info())

    def info(self) -> dict[str, Any]:
        """Return further values: time [s]."""
        return {"time": self.session.time}

    def close(self) -> None:
        """Close the files of the session."""
        self.session.finish()

    def _drawn(self, options: abc.Mapping[str, Any], name: str,
               draw: abc.Callable[[], float]) -> float:
        """Return an option, or a drawn value; draws in either case, to keep the sequence."""
        value = draw()
        return float(options.get(name, value))


class TowTension(SceneEnv):
    """Hold the tension of a towline by the speed of its winch, in waves.

    Action: winch speed over 1.5 m/s. Observation: (pull − target)/target, target/1 MN, winch
    speed [m/s], wire on the drum/100 m. Reward: −|pull − target|/target, −0.02 a². The episode ends
    when the wire is off the drum. Options: target [N], drawn from 0.25 to 0.6 MN.

    The scene has a winch of the name `winch`: scenes/tow_payout.json.
    """

    def __init__(self, scene: str | os.PathLike[str] = "scenes/tow_payout.json",
                 **given: Any) -> None:
        super().__init__(scene, {"winch.speed": 1.5}, 4, **given)
        self.target = 4e5

    def begin(self, options: abc.Mapping[str, Any]) -> None:
        self.target = self._drawn(options, "target", lambda: self.random.uniform(2.5e5, 6e5))
        self.session.inputs["winch.mode"] = 0  # speed
        self.session.inputs["winch.speed"] = 0.0
        self.session.inputs["winch.brake"] = 0.0
        self.session.step(self.steps)

    def _error(self) -> float:
        return (self.session.outputs["winch.pull"] - self.target) / self.target

    def observe(self) -> np.ndarray:
        out = self.session.outputs
        return np.array([self._error(), self.target / 1e6, out["winch.speed"],
                         out["winch.wire_left"] / 100.0])

    def reward(self, action: np.ndarray) -> float:
        return -abs(self._error()) - 0.02 * float(action @ action)

    def ended(self) -> bool:
        return self.session.outputs["winch.wire_left"] < 10.0


class AntiSway(SceneEnv):
    """Slew a crane to an angle without swing of its hook.

    Action: slew speed over its amplitude `speed` [rad/s]. Observation: angle to the target [rad],
    slew speed ordered before [rad/s], radial and tangential offset of the hook from the tip [m], and
    their rates [m/s]. Reward: −|angle| − 0.5·swing − 0.02 a². The episode ends when the angle is
    below 0.01 rad, and the swing below 0.1 m at less than 0.05 m/s, with the reward 10. Options:
    target [rad], drawn from ±0.3 to ±0.8.

    The scene has a crane of the name `crane` that stands at the origin: scenes/crane_knuckle.json.
    """

    def __init__(self, scene: str | os.PathLike[str] = "scenes/crane_knuckle.json", *,
                 speed: float = 0.06, **given: Any) -> None:
        super().__init__(scene, {"crane.slew": speed}, 6, **given)
        self.target = 0.5
        self._ordered = 0.0
        self._offset = np.zeros(2)
        self._rate = np.zeros(2)
        self.session.step()  # Outputs have values after a step.
        self._start = self.session.save()
        hook = np.array(self.session.world.body("crane/hook").position)[:2]
        slew, radius = self.session.outputs["slew"], self.session.outputs["crane.radius"]
        self._base = hook - radius * np.array([math.cos(slew), math.sin(slew)])

    def begin(self, options: abc.Mapping[str, Any]) -> None:
        self.target = self._drawn(options, "target", lambda: float(
            self.random.uniform(0.3, 0.8) * self.random.choice([-1.0, 1.0])))
        self._ordered = 0.0
        self._offset = self._hook_offset()
        self._rate = np.zeros(2)

    def _hook_offset(self) -> np.ndarray:
        """Return the radial and tangential offset of the hook from the tip [m]."""
        slew, radius = self.session.outputs["slew"], self.session.outputs["crane.radius"]
        hook = np.array(self.session.world.body("crane/hook").position)[:2] - self._base
        out, across = (np.array([math.cos(slew), math.sin(slew)]),
                       np.array([-math.sin(slew), math.cos(slew)]))
        return np.array([hook @ out - radius, hook @ across])

    def measure(self) -> None:
        offset = self._hook_offset()
        self._ordered = self.session.inputs["crane.slew"]
        self._rate = (offset - self._offset) / self.period
        self._offset = offset

    def observe(self) -> np.ndarray:
        return np.array([self.target - self.session.outputs["slew"], self._ordered, *self._offset,
                         *self._rate])

    def reward(self, action: np.ndarray) -> float:
        if self.ended():
            return 10.0
        angle = abs(self.target - self.session.outputs["slew"])
        return -angle - 0.5 * float(np.linalg.norm(self._offset)) - 0.02 * float(action @ action)

    def ended(self) -> bool:
        return (abs(self.target - self.session.outputs["slew"]) < 0.01
                and float(np.linalg.norm(self._offset)) < 0.1
                and float(np.linalg.norm(self._rate)) < 0.05)


class StationKeeping(SceneEnv):
    """Hold a ship at its place by joystick in wind, current and waves.

    Actions: joystick ahead, to starboard, turn to starboard. Observation, in the ship's frame with
    x ahead and y to starboard: offset [m], heading error clockwise [rad], velocities [m/s], turn
    rate clockwise [rad/s], wind [m/s] over 20 and the direction in which it blows as cosine and
    sine. Reward: −(offset/5 m)² − (error/0.1 rad)² − 0.05 a². The
    episode ends at an offset of 30 m. Options: wind [m/s], drawn from 5 to 12; direction [rad],
    drawn from all.

    The scene has a vessel with DP and a body of the name `ship`: scenes/dp_ship.json.
    """

    def __init__(self, scene: str | os.PathLike[str] = "scenes/dp_ship.json", *,
                 vessel: str = "dp", body: str = "ship", **given: Any) -> None:
        given = {"period": 0.5, "duration": 300.0} | given
        self._vessel, self._body = vessel, body
        super().__init__(scene, {f"{vessel}.joystick_{axis}": 1.0 for axis in "xyn"}, 9, **given)
        pose = self.session.world.body(body)
        self._place = np.array(pose.position)[:2]
        self._heading = self._yaw()

    def _yaw(self) -> float:
        w, x, y, z = self.session.world.body(self._body).orientation
        return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))

    def begin(self, options: abc.Mapping[str, Any]) -> None:
        wind = self._drawn(options, "wind", lambda: self.random.uniform(5.0, 12.0))
        direction = self._drawn(options, "direction",
                                lambda: self.random.uniform(-math.pi, math.pi))
        inputs = self.session.inputs
        inputs[f"{self._vessel}.mode"] = 1  # joystick
        inputs["sea.wind"], inputs["sea.wind_direction"] = wind, direction

    @staticmethod
    def _in_ship(vector: np.ndarray, yaw: float) -> np.ndarray:
        """Return components ahead and to starboard of a horizontal vector of the world."""
        c, s = math.cos(yaw), math.sin(yaw)
        return np.array([c * vector[0] + s * vector[1], s * vector[0] - c * vector[1]])

    def _error(self) -> tuple[np.ndarray, float]:
        yaw = self._yaw()
        offset = np.array(self.session.world.body(self._body).position)[:2] - self._place
        turn = self._heading - yaw
        return self._in_ship(offset, yaw), math.atan2(math.sin(turn), math.cos(turn))

    def observe(self) -> np.ndarray:
        body = self.session.world.body(self._body)
        offset, turn = self._error()
        yaw = self._yaw()
        speed = self._in_ship(np.array(body.velocity)[:2], yaw)
        wind = yaw - self.session.inputs["sea.wind_direction"]
        return np.array([*offset, turn, *speed, -body.angular_velocity[2],
                         self.session.inputs["sea.wind"] / 20.0, math.cos(wind), math.sin(wind)])

    def reward(self, action: np.ndarray) -> float:
        offset, turn = self._error()
        return (-float(offset @ offset) / 25.0 - (turn / 0.1)**2
                - 0.05 * float(action @ action))

    def ended(self) -> bool:
        return float(np.linalg.norm(self._error()[0])) > 30.0
