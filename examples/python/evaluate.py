#!/usr/bin/env python3
"""The reduced energy, force and tangent stiffness of a model's polynomial at z, and how far they are from what NumPy makes
of its coefficients:
  evaluate.py MODEL.h5 [Z,...]    (z in sqrt(kg) m; without it, the first coordinate is 1e-3 of its unit)"""
import sys
from itertools import combinations_with_replacement, permutations

import numpy as np
import ritz


def tensor(unique, r, order):
    """The full symmetric tensor of the entries i ≤ j ≤ ... in lexicographic order."""
    full = np.zeros((r,) * order)
    for value, index in zip(unique, combinations_with_replacement(range(r), order)):
        for at in set(permutations(index)):
            full[at] = value
    return full


def by_numpy(polynomial, z):
    A, B, C = (tensor(unique, polynomial.r, order) for unique, order in
               ((polynomial.quadratic, 2), (polynomial.cubic, 3), (polynomial.quartic, 4)))
    cubic, quartic = B @ z, C @ z @ z
    return z @ (A / 2 + cubic / 6 + quartic / 24) @ z, (A + cubic / 2 + quartic / 6) @ z, A + cubic + quartic / 2


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    body = ritz.read(sys.argv[1])
    z = np.array(sys.argv[2].split(","), float) if len(sys.argv) > 2 else 1e-3 * np.eye(body.r)[0]
    energy, force, tangent = here = body.equation().evaluate(z)
    print(f"energy {energy:.12g} J\nforce {' '.join(f'{f:.12g}' for f in force)}")
    print(f"smallest eigenvalue of the tangent {np.linalg.eigvalsh(tangent)[0]:.12g} 1/s²")
    for name, ours, numpy_s in zip(("energy", "force", "tangent"), here, by_numpy(body.polynomial, z)):
        print(f"{name} differs from NumPy's by {np.abs(ours - numpy_s).max() / np.abs(numpy_s).max():.1e} of the largest")
