# SPDX-License-Identifier: Apache-2.0
"""Functions of studies in tests; worker processes import them."""
import os


def position(session):
    """Return the position of the pendulum at the end."""
    return {"x": session.world.body("bob").position[0]}


def fail_if_heavy(session):
    """Raise for a mass above 2 kg."""
    if session.world.body("bob").mass > 2.0:
        raise RuntimeError("too heavy")
    return position(session)


def die_if_heavy(session):
    """End the worker process for a mass above 2 kg."""
    if session.world.body("bob").mass > 2.0:
        os._exit(9)
    return position(session)
