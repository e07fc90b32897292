# SPDX-License-Identifier: Apache-2.0
"""Test systems written in Python: loads, signals, state, errors, lifetime."""
import gc
import math
import traceback
import weakref

import numpy as np
import pytest

import hawser


class Spring(hawser.System):
    """Spring to the origin along x, with its own count of steps.

    It refers to its body by name, so that a clone acts on the body of a twin.
    """

    def __init__(self, body, stiffness):
        super().__init__("spring", state=1)
        self.body = body
        self.add_input("stiffness", "N/m", stiffness, 0.0, 1e6)
        self.add_output("force", "N")

    def prestep(self, step, loads):
        force = -self["stiffness"] * step.world.body(self.body).position[0]
        self["force"] = force
        self.state[0] += 1.0
        loads.add_force(self.body, (force, 0.0, 0.0))


@pytest.fixture
def oscillator():
    world = hawser.World(step=0.001, gravity=(0, 0, 0))
    body = world.add_body(name="mass", kind="lump", position=(1.0, 0.0, 0.0), mass=2.0)
    return world, world.add_system(Spring(body.name, 50.0))


def test_oscillator_has_the_period_of_theory(oscillator):
    world, spring = oscillator
    omega = math.sqrt(50.0 / 2.0)
    world.step(2000)
    # Second order in h: the phase error after ω t is ω t (ω h)²/24 = 1e-5.
    assert world.position[0, 0] == pytest.approx(math.cos(omega * 2.0), abs=5e-5)
    assert spring.state[0] == 2000.0
    assert world.signal("spring.force") == pytest.approx(-50.0 * world.position[0, 0], rel=0.02)


def test_signals_and_state_are_saved(oscillator):
    world, spring = oscillator
    world.step(10)
    state = world.save()
    world.set_signal("spring.stiffness", 500.0)
    world.step(10)
    assert spring["stiffness"] == 500.0 and spring.state[0] == 20.0
    after = world.state_hash
    world.restore(state)
    assert spring["stiffness"] == 50.0 and spring.state[0] == 10.0
    world.set_signal("spring.stiffness", 500.0)
    world.step(10)
    assert world.state_hash == after
    with pytest.raises(hawser.DefError, match="did you mean"):
        world.set_signal("spring.stifness", 1.0)


def test_error_surfaces_with_its_place_and_undoes_the_step(oscillator):
    world, _ = oscillator

    class Faulty(hawser.System):
        def __init__(self):
            super().__init__("faulty")
            self.fails = True

        def prestep(self, step, loads):
            if self.fails and step.count == 7:
                raise ZeroDivisionError("in the controller")

    faulty = world.add_system(Faulty())
    with pytest.raises(ZeroDivisionError, match="in the controller") as error:
        world.step(20)
    text = "".join(traceback.format_exception(error.value))
    assert "prestep" in text and "test_system.py" in text
    assert world.step_count == 7
    hash_before = world.state_hash
    with pytest.raises(ZeroDivisionError):
        world.step()
    assert world.state_hash == hash_before
    faulty.fails = False
    world.step(13)
    assert world.step_count == 20


@pytest.mark.parametrize("act", [
    lambda s, step, loads: loads.add_force("nobody", (0, 0, 0)),
    lambda s, step, loads: loads.add_force("mass", (0, math.nan, 0)),
    lambda s, step, loads: loads.add_damping("mass", np.zeros((2, 3))),
    lambda s, step, loads: step.world.add_body(kind="fixed"),
    lambda s, step, loads: step.world.step(),
    lambda s, step, loads: step.set_input("none", 1.0),
    lambda s, step, loads: s["none"],
])
def test_errors_in_every_call_of_a_system(oscillator, act):
    world, _ = oscillator
    system = type("Acting", (hawser.System,), {"prestep": act})("acting")
    world.add_system(system)
    before = world.state_hash
    with pytest.raises((hawser.Error, ValueError, KeyError)):
        world.step()
    assert world.state_hash == before
    world.remove_system(system)
    world.step()


def test_load_that_is_not_positive_is_named(oscillator):
    world, _ = oscillator
    system = type("Negative", (hawser.System,),
                  {"prestep": lambda s, step, loads: loads.add_damping("mass", -np.eye(3))})("neg")
    world.add_system(system)
    with pytest.raises(hawser.StepError, match="neg.*mass") as error:
        world.step()
    assert error.value.status


def test_step_and_loads_end_with_the_step(oscillator):
    world, _ = oscillator
    kept = []
    system = type("Keeper", (hawser.System,),
                  {"prestep": lambda s, step, loads: kept.extend((step, loads))})("keeper")
    world.add_system(system)
    world.step()
    with pytest.raises(hawser.UseError, match="prestep"):
        print(kept[0].time)
    with pytest.raises(hawser.UseError, match="prestep"):
        kept[1].add_force("mass", (1, 0, 0))


def test_implicit_damping_is_stable(oscillator):
    """A damper with D h/m = 50 would explode explicitly."""
    world, _ = oscillator
    damper = type("Damper", (hawser.System,),
                  {"prestep": lambda s, step, loads: loads.add_damping("mass", 1e5 * np.eye(3))})
    world.add_system(damper("damper"))
    world.step(100)
    assert abs(world.velocity[0]) < 1e-2


def test_a_system_acts_on_one_world(oscillator):
    world, spring = oscillator
    with pytest.raises(hawser.DefError, match="already acts"):
        hawser.World().add_system(spring)
    world.remove_system(spring)
    with pytest.raises(hawser.DefError, match="no world"):
        world.remove_system(spring)
    with pytest.raises(ValueError, match="hawser.System"):
        world.add_system(object())


def test_held_objects_stay(oscillator):
    world, spring = oscillator
    body = world.body("mass")
    spring.holds = lambda: [body]
    with pytest.raises(hawser.DefError, match="spring"):
        body.remove()


def test_clone_makes_twins_possible(oscillator):
    world, spring = oscillator
    with pytest.raises(hawser.DefError):
        world.twin()
    spring.clone = lambda: Spring(spring.body, 50.0)
    world.step(5)
    twin = world.twin()
    world.step(5)
    twin.step(5)
    assert twin.state_hash == world.state_hash


@pytest.mark.parametrize("method, result, error", [
    ("clone", lambda: 1 / 0, ZeroDivisionError), ("clone", lambda: 3, ValueError),
    ("clone", None, hawser.DefError), ("holds", lambda: 1 / 0, ZeroDivisionError),
    ("holds", lambda: [1], ValueError), ("holds", lambda: 1, TypeError),
])
def test_errors_in_other_methods_change_nothing(oscillator, method, result, error):
    world, spring = oscillator
    setattr(spring, method, result or (lambda: spring))
    body, before = world.body("mass"), world.state_hash
    with pytest.raises(error):
        world.twin() if method == "clone" else body.remove()
    assert body.alive and world.state_hash == before
    delattr(spring, method)
    world.step(3)
    assert spring.state[0] == 3.0


def test_errors_in_the_callback_of_a_run(scenes):
    session = hawser.load(scenes / "pendulum.json")
    with pytest.raises(ZeroDivisionError):
        session.run(1.0, every=0.1, callback=lambda s: 1 / 0, progress=False)
    assert session.time == pytest.approx(0.1)
    session.run(1.0, progress=False)
    assert session.time == pytest.approx(1.0)


def test_cycles_are_collected():
    references = []
    for _ in range(10):
        world = hawser.World()
        world.add_body(name="mass", kind="lump", mass=1.0)
        spring = Spring(world.body("mass").name, 1.0)
        spring.world = world
        world.add_system(spring)
        references.append(weakref.ref(spring))
        del world, spring
    gc.collect()
    assert sum(r() is not None for r in references) == 0
