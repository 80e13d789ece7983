#!/usr/bin/env python3
"""The reduced energy, force and tangent stiffness of a model's polynomial at z, from the file alone:
evaluate.py MODEL.h5 [Z,...]    (z in sqrt(kg) m; without it, the first coordinate is 1e-3 of its unit)"""
import sys
from itertools import combinations_with_replacement, permutations

import h5py
import numpy as np


def tensor(unique, r, order):
    """The full symmetric tensor of the entries i ≤ j ≤ ... in lexicographic order."""
    full = np.zeros((r,) * order)
    for value, index in zip(unique, combinations_with_replacement(range(r), order)):
        for at in set(permutations(index)):
            full[at] = value
    return full


def evaluate(A, B, C, z):
    cubic, quartic = B @ z, C @ z @ z
    return z @ (A / 2 + cubic / 6 + quartic / 24) @ z, (A + cubic / 2 + quartic / 6) @ z, A + cubic + quartic / 2


if __name__ == "__main__":
    with h5py.File(sys.argv[1]) as file:
        part = next(iter(file["bodies"].values()))["polynomial"]
        r = int(round((np.sqrt(8 * len(part["quadratic"]) + 1) - 1) / 2))
        A, B, C = (tensor(part[name][:], r, order) for name, order in (("quadratic", 2), ("cubic", 3), ("quartic", 4)))
    z = np.array(sys.argv[2].split(","), float) if len(sys.argv) > 2 else 1e-3 * np.eye(r)[0]
    energy, force, tangent = evaluate(A, B, C, z)
    print(f"energy {energy:.12g} J\nforce {' '.join(f'{f:.12g}' for f in force)}")
    print(f"smallest eigenvalue of the tangent {np.linalg.eigvalsh(tangent)[0]:.12g} 1/s²")
