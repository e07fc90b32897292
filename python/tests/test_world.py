# SPDX-License-Identifier: Apache-2.0
"""Test worlds: definitions, arrays, handles, errors, threads, interrupts."""
import copy
import gc
import math
import os
import signal
import threading
import time

import numpy as np
import pytest

import hawser


def test_pendulum_has_the_period_of_theory():
    """Period of a pendulum of 1 m at 0.1 rad: 2π √(l/g) (1 + θ²/16)."""
    world = hawser.World(step=0.001)
    a = 0.1
    world.add_body(name="ground", kind="fixed")
    bob = world.add_body(kind="lump", position=(math.sin(a), 0.0, -math.cos(a)), mass=2.0)
    world.add_distance(a="ground", b=bob)
    x, before, crossings = world.position, math.sin(a), []
    while len(crossings) < 3:
        world.step()
        now = x[bob.index, 0]
        if before < 0.0 <= now:
            crossings.append(world.time - 0.001 * now / (now - before))
        before = now
    expected = 2.0 * math.pi * math.sqrt(1.0 / 9.81) * (1.0 + a * a / 16.0)
    # The scheme's error is of second order: (ω h)²/24 = 4e-7.
    assert np.diff(crossings) == pytest.approx([expected] * 2, rel=5e-6)


def test_arrays_share_the_memory(pendulum):
    x = pendulum.position
    assert x.shape == (2, 3) and x.dtype == np.float64
    assert pendulum.orientation.shape == (2, 4)
    assert pendulum.velocity.shape == (3,)
    assert not x.flags.writeable and not x.flags.owndata
    with pytest.raises(ValueError):
        x[0, 0] = 1.0
    with pytest.raises(ValueError):
        x.flags.writeable = True
    before = x.copy()
    pendulum.step(10)
    assert np.shares_memory(x, pendulum.position)
    assert not np.array_equal(before, x)
    assert np.array_equal(x[1], pendulum.body("bob").position)


def test_old_arrays_follow_a_growing_world(pendulum):
    x, row = pendulum.position, pendulum.position[1]
    for i in range(3000):
        pendulum.add_body(kind="lump", position=(5.0, 0.0, float(i)), mass=1.0)
    assert pendulum.position.shape == (3002, 3)
    assert not np.shares_memory(x, pendulum.position)
    pendulum.step(3)
    assert np.array_equal(x, pendulum.position[:2])
    assert np.array_equal(row, pendulum.body("bob").position)


def test_arrays_outlive_the_world(pendulum):
    pendulum.step(5)
    x, expected = pendulum.position, pendulum.position.copy()
    world = hawser.World()
    world.add_body(name="a", kind="fixed")
    y = world.position
    del world
    gc.collect()
    assert np.array_equal(y, np.zeros((1, 3)))
    assert np.array_equal(x, expected)


def test_worlds_come_and_go():
    """HAWSER_TIER=full: 1,000 worlds, else 100. Each takes 2 ms and several thread switches."""
    kept = []
    for i in range(1000 if os.environ.get("HAWSER_TIER") in ("full", "long") else 100):
        world = hawser.World()
        world.add_body(kind="fixed", position=(float(i), 0.0, 0.0))
        if i % 10 == 0:
            kept.append(world.position)
        del world
    assert [k[0, 0] for k in kept] == [10.0 * i for i in range(len(kept))]


@pytest.mark.parametrize("given, error, words", [
    ({"position": (1.0, 2.0)}, ValueError, r"body.position.*\(3,\).*float64.*\(2,\).*float64"),
    ({"position": ["a", "b", "c"]}, ValueError, r"\(3,\).*<U1"),
    ({"position": np.zeros(3, complex)}, ValueError, "complex128"),
    ({"inertia": np.eye(2)}, ValueError, r"\(3, 3\).*\(2, 2\)"),
    ({"mass": math.nan}, ValueError, "body.mass.*NaN"),
    ({"position": (0.0, math.nan, 0.0)}, ValueError, "value 1 is NaN"),
    ({"mass": "heavy"}, ValueError, "body.mass.*number.*str"),
    ({"kind": "lmp"}, ValueError, "nearest: \"lump\""),
    ({"masss": 1.0}, TypeError, "nearest: \"mass\""),
    ({"gravity": 1}, ValueError, "True or False"),
    ({"mass": -1.0}, hawser.DefError, "mass"),
    ({"name": "ground"}, hawser.DefError, "ground"),
])
def test_bad_input_is_refused(pendulum, given, error, words):
    count = len(pendulum.bodies)
    with pytest.raises(error, match=words):
        pendulum.add_body(**{"kind": "lump", "mass": 1.0, **given})
    assert len(pendulum.bodies) == count


def test_settings_are_checked():
    with pytest.raises(TypeError, match="nearest: \"gravity\""):
        hawser.World(gravty=(0, 0, 1))
    with pytest.raises(hawser.DefError, match="step"):
        hawser.World(step=2.0)
    with pytest.raises(ValueError, match="step.*number"):
        hawser.World(step="fast")
    assert hawser.World(form="saddle", gravity=(0, 0, -1)).settings["form"] == "saddle"


def test_handles_of_removed_objects(pendulum):
    bob, rod = pendulum.body("bob"), pendulum.interaction("rod")
    assert bob == pendulum.body("bob") and hash(bob) == hash(pendulum.body("bob"))
    bob.remove()
    assert not bob.alive and not rod.alive
    for call in (lambda: bob.position, lambda: rod.force, bob.remove,
                 lambda: pendulum.add_distance(a="ground", b=bob)):
        with pytest.raises(hawser.RemovedError):
            call()
    again = pendulum.add_body(name="bob", kind="lump", mass=1.0)
    assert again.index == bob.index and again != bob
    with pytest.raises(KeyError):
        pendulum.body("nobody")
    other = hawser.World()
    with pytest.raises(hawser.DefError, match="another world"):
        other.add_hydrostatic(body=again)


def test_handle_without_world():
    world = hawser.World()
    body = world.add_body(kind="fixed")
    del world
    gc.collect()
    with pytest.raises(hawser.RemovedError, match="does not exist"):
        print(body.position)


def test_wire_and_winch():
    world = hawser.World()
    ship = world.add_body(name="ship", kind="fixed")
    weight = world.add_body(name="weight", kind="lump", position=(0, 0, -20.0), mass=1000.0)
    wire = world.add_wire(name="hoist", from_=ship, to=weight, elements=10, EA=1e7,
                          mass_per_length=5.0, consistent_mass=True)
    ids = world.add_winch(name="winch", wire=wire, core_radius=0.4, width=1.0, wire_diameter=0.03,
                          mass_per_length=5.0, stored=200.0, inertia=500.0, brake_static=1e6,
                          mode="brake")
    assert ids.chain is None and ids.drum.name == "winch/drum"
    world.step(1200)
    # At rest: weight below, weight and wire above; an element has its mean tension.
    tension = wire.tension
    assert not tension.flags.writeable
    assert tension[-1] == pytest.approx(9.81 * (1000.0 + 5.0 * 1.0), rel=5e-3)
    assert np.all(np.diff(tension) < 0.0)
    piece = wire.cut(10.0)
    assert piece.name == "hoist/2"
    with pytest.raises(hawser.DefError):
        wire.tension_at(1e6)


def test_outputs_and_inputs(pendulum):
    out = pendulum.add_output(name="height", kind="pose", body="bob", component="z")
    pull = pendulum.add_input(name="pull", body="bob", component=0, min=-5.0, max=5.0)
    pull.value = 7.0
    assert pull.value == 5.0
    pendulum.step(3)
    assert out.value == pendulum.position[1, 2]
    assert pendulum.output_values[0] == out.value
    with pytest.raises(ValueError):
        pull.value = math.nan


def test_contacts(pendulum):
    world = hawser.World()
    world.add_body(name="floor", kind="fixed")
    world.add_shape(kind="plane", body="floor")
    ball = world.add_body(kind="rigid", position=(0, 0, 0.5), mass=2.0, inertia=0.2 * np.eye(3))
    world.add_shape(kind="sphere", body=ball, radius=0.5)
    world.step(120)
    contacts = world.contacts()
    assert len(contacts) == 1 and not contacts.flags.writeable
    assert abs(contacts["force"][0, 2]) == pytest.approx(2.0 * 9.81, rel=1e-3)
    assert abs(contacts["normal"][0, 2]) == pytest.approx(1.0)


def test_twin_and_state(pendulum):
    pendulum.step(10)
    twin, state = copy.deepcopy(pendulum), pendulum.save()
    pendulum.step(10)
    twin.step(10)
    assert twin.state_hash == pendulum.state_hash
    pendulum.restore(state)
    pendulum.step(10)
    assert twin.state_hash == pendulum.state_hash
    with pytest.raises(TypeError, match="pickle"):
        copy.copy(pendulum)


def heavy_world(n=14):
    """Return a world whose step takes long: a block of bodies joined in a grid."""
    world = hawser.World()
    bodies = {}
    for i in range(n):
        for j in range(n):
            for k in range(n):
                bodies[i, j, k] = world.add_body(
                    kind="rigid", position=(i, j, k), mass=1.0, inertia=np.eye(3))
    for (i, j, k), a in bodies.items():
        for b in ((i + 1, j, k), (i, j + 1, k), (i, j, k + 1)):
            if b in bodies:
                world.add_ball(a=a, b=bodies[b], point=(i, j, k), compliance=1e-6)
    return world


def test_two_threads_in_one_world_raise(pendulum):
    world, raised = heavy_world(6), []
    world.prepare()
    started = threading.Event()

    def steps():
        started.set()
        world.step(40)

    thread = threading.Thread(target=steps)
    thread.start()
    started.wait()
    while thread.is_alive() and not raised:
        try:
            world.step()
        except hawser.UseError:
            raised.append(True)
    thread.join()
    assert raised


def test_the_lock_is_released_while_stepping():
    world, counted = heavy_world(6), [0]
    world.prepare()
    thread = threading.Thread(target=lambda: world.step(40))
    thread.start()
    while thread.is_alive():
        counted[0] += 1
        time.sleep(0.001)
    thread.join()
    assert counted[0] > 5


def test_interrupt_between_short_steps(pendulum):
    """Honour Ctrl-C in a long run of short steps."""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # Shells let background jobs ignore it.
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        pendulum.step(10**9)
    count = pendulum.step_count
    assert count > 0
    pendulum.step()
    assert pendulum.step_count == count + 1


def test_a_handler_that_goes_on_keeps_the_run(pendulum):
    seen = []
    earlier = signal.signal(signal.SIGINT, lambda *_: seen.append(1))
    try:
        twin = pendulum.twin()
        timer = threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        while not seen:
            pendulum.step(100)
        twin.step(pendulum.step_count)
        assert pendulum.state_hash == twin.state_hash
    finally:
        signal.signal(signal.SIGINT, earlier)


def box_mesh(size):
    """Return the mesh of a box with half sizes, with normals outwards."""
    vertices = [[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)] * np.array(size)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return {"vertices": vertices,
            "triangles": [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]}


def heave_period(tmp_path, **hull):
    """Return the period of small heave of a box of 20 × 10 m with 1 m draught, from 0.02 m."""
    world = hawser.World(step=0.02)
    mass = 1025.0 * 20.0 * 10.0 * 1.0
    body = world.add_body(name="box", position=(0.0, 0.0, 0.52), mass=mass,
                          inertia=mass * np.diag([10.0, 35.0, 40.0]))
    world.add_sea(depth=100.0, hulls=[{"body": body, "mesh": box_mesh([10.0, 5.0, 1.5]),
                                       "wave_pressure": False, **hull}])
    heights = []
    for _ in range(600):
        world.step()
        heights.append(world.position[body.index, 2])
    return hawser.stats.up_crossing_period(heights, 0.02, 0.5)


def test_hulls_with_files_of_coefficients(tmp_path):
    """Heave of a box: T = 2π √((m + A)/(ρ g S))."""
    stiffness, mass = 1025.0 * 9.81 * 200.0, 1025.0 * 200.0
    plain = 2.0 * math.pi * math.sqrt(mass / stiffness)
    assert heave_period(tmp_path) == pytest.approx(plain, rel=5e-3)
    # A WAMIT file: period, mode, mode, A/(ρ L³), B/(ρ L³ ω). The added mass equals the mass.
    rows = [f"{period} {i} {i} {200.0 if i <= 3 else 4000.0} 0.0" for period in (3.0, 4.0, 6.0)
            for i in range(1, 7)]
    file = tmp_path / "box.1"
    file.write_text("\n".join(rows) + "\n")
    added = {"radiation": "constant", "constant_period": 4.0}
    with_file = heave_period(tmp_path, coefficients=file, **added)
    assert with_file == pytest.approx(plain * math.sqrt(2.0), rel=5e-3)
    half = heave_period(tmp_path, coefficients={"file": str(file), "density": 512.5}, **added)
    assert half == pytest.approx(plain * math.sqrt(1.5), rel=5e-3)
    for wrong, words in ((3, "path"), ({"density": 1.0}, "the key file"),
                         (str(tmp_path / "no.1"), "no.1")):
        with pytest.raises(ValueError, match=words):
            heave_period(tmp_path, coefficients=wrong, **added)
    with pytest.raises(TypeError, match="nearest: \"density\""):
        heave_period(tmp_path, coefficients={"file": str(file), "densty": 1.0}, **added)
