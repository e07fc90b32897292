# SPDX-License-Identifier: Apache-2.0
"""Static equilibrium of hanging lines and of floating bodies held by them (numpy only).

Two independent tools, neither of which uses the engine:

* `hang` / `solve_line`: closed form of the elastic catenary (Irvine, Cable Structures, 1981,
  ch. 1), for lines that may consist of several segments and point weights. It gives line
  lengths for required tensions.
* `Statics`: Newton's method on the lumped model itself (point masses joined by linear springs,
  rigid bodies with six degrees of freedom), with the full geometric stiffness. Its result is
  the reference for the engine's settled state. Bending is neglected: with EI / (T a²) below 1e-6
  it moves no node by more than millimetres.
"""

import numpy as np

G = 9.81


def skew(a):
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def rotation(v):
    """Return the rotation matrix of a rotation vector [rad]."""
    angle = np.linalg.norm(v)
    if angle < 1e-12:
        return np.eye(3) + skew(v)
    k = skew(v / angle)
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def hang(segments, h, v):
    """Return the end point (x, z) of a line that starts with horizontal tension h and upward
    vertical component v [N] along its tangent. A segment is (weight per length [N/m], EA [N],
    length [m]) or a point weight [N]. Returns x, z and the vertical component at the end."""
    x = z = 0.0
    for s in segments:
        if np.isscalar(s):
            v += s
            continue
        w, ea, length = s
        v1 = v + w * length
        x += h / w * (np.arcsinh(v1 / h) - np.arcsinh(v / h)) + h * length / ea
        z += (np.hypot(h, v1) - np.hypot(h, v)) / w + (v1 * v1 - v * v) / (2 * w * ea)
        v = v1
    return x, z, v


def solve_line(make_segments, span, height, h, length, v=0.0):
    """Find length and start slope for a given horizontal tension: unknowns (length, v) such that
    hang(make_segments(length), h, v) ends at (span, height)."""
    for _ in range(100):
        f = np.array(hang(make_segments(length), h, v)[:2]) - (span, height)
        if np.abs(f).max() < 1e-10 * span:
            break
        dl, dv = 1e-6 * length, 1e-6 * h
        a = (np.array(hang(make_segments(length + dl), h, v)[:2]) - (span, height) - f) / dl
        b = (np.array(hang(make_segments(length), h, v + dv)[:2]) - (span, height) - f) / dv
        step = np.linalg.solve(np.column_stack([a, b]), -f)
        step *= min(1.0, 0.1 * length / abs(step[0]), 0.5 * h / abs(step[1]))
        length, v = length + step[0], v + step[1]
    return length, v


class Statics:
    """Points, rigid bodies and springs. Ends are ("node", i), ("body", i, local arm) or
    ("fixed", position)."""

    def __init__(self):
        self.nodes, self.node_weight = [], []
        self.bodies, self.springs = [], []
        self.lines = []  # (first node, one past the last) of each line

    def add_node(self, position, weight):
        self.nodes.append(np.array(position, float))
        self.node_weight.append(weight)
        return len(self.nodes) - 1

    def add_body(self, position, yaw=0.0, force=(0, 0, 0), heave=(0, 0), tilt=(0, 0), loads=()):
        """heave = (stiffness, rest height), tilt = (roll, pitch) stiffness in the body's frame,
        loads = [(weight [N], local arm)] of bodies carried, force: constant, at the centre."""
        self.bodies.append({"x": np.array(position, float), "R": rotation([0, 0, yaw]),
                            "force": np.array(force, float), "heave": heave, "tilt": tilt,
                            "loads": [(w, np.array(a, float)) for w, a in loads]})
        return len(self.bodies) - 1

    def add_spring(self, a, b, length, ea):
        self.springs.append((a, b, length, ea))

    def add_line(self, a, b, length, n, weight, ea):
        """n equal springs from end a to end b on a parabola. weight: per length [N/m].
        Returns the first spring and n."""
        p, q = self.point(a), self.point(b)
        slack = length**2 - (q - p) @ (q - p)
        sag = np.sqrt(max(0.0, 0.2 * slack))
        chain = [a]
        for k in range(1, n):
            u = k / n
            at = p + (q - p) * u - [0, 0, sag * 4 * u * (1 - u)]
            chain.append(("node", self.add_node(at, weight * length / n)))
        chain.append(b)
        self.lines.append((len(self.nodes) - (n - 1), len(self.nodes)))
        for c, d in zip(chain, chain[1:]):
            self.add_spring(c, d, length / n, ea)
        return len(self.springs) - n, n

    def point(self, end):
        if end[0] == "node":
            return self.nodes[end[1]]
        if end[0] == "fixed":
            return np.array(end[1], float)
        body = self.bodies[end[1]]
        return body["x"] + body["R"] @ np.array(end[2], float)

    def tension(self, i):
        a, b, length, ea = self.springs[i]
        return ea * (np.linalg.norm(self.point(b) - self.point(a)) / length - 1)

    def _columns(self, end):
        """Return the index of the first unknown and the matrix d(point)/d(unknowns), or None."""
        if end[0] == "fixed":
            return None
        if end[0] == "node":
            return 6 * len(self.bodies) + 3 * end[1], np.eye(3)
        arm = self.bodies[end[1]]["R"] @ np.array(end[2], float)
        return 6 * end[1], np.hstack([np.eye(3), -skew(arm)])

    def _push(self, force, stiffness, end, f):
        """Apply force f at an end, with the stiffness of its arm."""
        cols = self._columns(end)
        if cols is None:
            return
        i, jac = cols
        force[i:i + jac.shape[1]] += jac.T @ f
        if end[0] == "body":
            arm = np.array([jac[1, 5], jac[2, 3], jac[0, 4]])  # out of −skew(arm)
            k = (f @ arm) * np.eye(3) - np.outer(arm, f)
            stiffness[i + 3:i + 6, i + 3:i + 6] += (k + k.T) / 2

    def assemble(self):
        n = 6 * len(self.bodies) + 3 * len(self.nodes)
        force, stiffness = np.zeros(n), np.zeros((n, n))
        for i, w in enumerate(self.node_weight):
            force[6 * len(self.bodies) + 3 * i + 2] -= w
        for i, b in enumerate(self.bodies):
            self._assemble_body(force, stiffness, i, b)
        for a, b, length, ea in self.springs:
            d = self.point(b) - self.point(a)
            l = np.linalg.norm(d)
            u, t = d / l, ea * (l / length - 1)
            self._push(force, stiffness, a, t * u)
            self._push(force, stiffness, b, -t * u)
            k = ea / length * np.outer(u, u) + t / l * (np.eye(3) - np.outer(u, u))
            ends = [(self._columns(e), s) for e, s in ((a, -1), (b, 1))]
            for ci, si in ends:
                for cj, sj in ends:
                    if ci and cj:
                        (p, jp), (q, jq) = ci, cj
                        stiffness[p:p + jp.shape[1], q:q + jq.shape[1]] += \
                            si * sj * jp.T @ k @ jq
        return force, stiffness

    def _assemble_body(self, force, stiffness, i, b):
        s = 6 * i
        force[s:s + 3] += b["force"]
        k, rest = b["heave"]
        force[s + 2] -= k * (b["x"][2] - rest)
        stiffness[s + 2, s + 2] += k
        up = b["R"][:, 2]
        heading = np.arctan2(b["R"][1, 0], b["R"][0, 0])
        yaw = rotation([0, 0, heading])
        kt = yaw @ np.diag([b["tilt"][0], b["tilt"][1], 0]) @ yaw.T
        force[s + 3:s + 6] -= kt @ np.cross([0, 0, 1], up)
        stiffness[s + 3:s + 6, s + 3:s + 6] += kt
        for w, arm in b["loads"]:
            self._push(force, stiffness, ("body", i, arm), np.array([0, 0, -w]))

    def _newton_step(self, force, stiffness):
        """Solve stiffness · dx = force. Lines touch each other only through bodies, so each is
        eliminated on its own."""
        nb = 6 * len(self.bodies)
        a, r, lines = stiffness[:nb, :nb].copy(), force[:nb].copy(), []
        for first, last in self.lines:
            s = slice(nb + 3 * first, nb + 3 * last)
            x = np.linalg.solve(stiffness[s, s], np.column_stack([force[s], stiffness[s, :nb]]))
            r -= stiffness[:nb, s] @ x[:, 0]
            a -= stiffness[:nb, s] @ x[:, 1:]
            lines.append((s, x))
        dx = np.zeros(len(force))
        dx[:nb] = np.linalg.solve(a, r)
        for s, x in lines:
            dx[s] = x[:, 0] - x[:, 1:] @ dx[:nb]
        return dx

    def solve(self, tolerance=1e-3, report=lambda s: None):
        """Apply Newton's method with limited steps; residual in N (forces) and N m (moments)."""
        for it in range(200):
            force, stiffness = self.assemble()
            worst = np.abs(force).max()
            report(f"  iteration {it}: residual {worst:.3e}")
            if worst < tolerance:
                return worst
            dx = self._newton_step(force, stiffness)
            dx *= min(1.0, 3.0 / np.abs(dx).max())
            nb = 6 * len(self.bodies)
            for i, b in enumerate(self.bodies):
                b["x"] = b["x"] + dx[6 * i:6 * i + 3]
                b["R"] = rotation(dx[6 * i + 3:6 * i + 6]) @ b["R"]
            for i in range(len(self.nodes)):
                self.nodes[i] = self.nodes[i] + dx[nb + 3 * i:nb + 3 * i + 3]
        raise RuntimeError("no static equilibrium found")
