#!/usr/bin/env python3
"""Pulls one vertex of a reduced model down for a second, lets go, and prints where it goes: time, u_x, u_y, u_z.
  push.py MODEL.h5 VERTEX      (by the mesh file's own number)"""
import sys

import numpy as np
import ritz


def push(model, vertex):
    body = ritz.read(model)
    moving = body.equation(alpha=0.5).instance(0.01)
    at_vertex = body.unit_force(vertex)  # (r, 3): what 1 N along x, y, z does; its transpose reads the vertex
    pull = at_vertex @ [0, 0, -1]
    for n in range(1, 201):
        moving.step(pull if n <= 100 else np.zeros(body.r))
        yield moving.t, *at_vertex.T @ moving.z


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    for t, x, y, z in push(sys.argv[1], int(sys.argv[2])):
        print(f"{t:.2f} {x:.9g} {y:.9g} {z:.9g}")
