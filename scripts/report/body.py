"""The body of a scene: its mesh in the order of its file, what is free, and its mass matrix."""
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np
import scipy.sparse

from bench import report_of, text

MAT_FILE_CLASSID = 1211216  # of PETSc


@dataclass(frozen=True)
class Body:
    ids: np.ndarray  # the vertices' numbers in the file's order
    free: np.ndarray  # of the 3 n components, vertex by vertex
    mass: scipy.sparse.csr_matrix  # of the free ones
    facts: dict  # columns of runs.csv

    def frames(self, path):
        """Times and displacements (frames x free components) of a motion that ritz-run or ritz-full wrote."""
        with h5py.File(path) as file:
            place = np.argsort(file["vertex_ids"][:])[np.argsort(np.argsort(self.ids))]
            times = file["frame_times" if "frame_times" in file else "times"][:]
            u = file["displacement"][:].astype(float)[:, place]
        return times, u.reshape(len(times), -1)[:, self.free]


def read_petsc(path):
    """A sparse matrix from PETSc's binary file: big endian, 32-bit indices."""
    raw = Path(path).read_bytes()
    kind, rows, columns, entries = np.frombuffer(raw, ">i4", 4)
    if kind != MAT_FILE_CLASSID:
        raise ValueError(f"{path}: not a sparse matrix of PETSc's with 32-bit indices")
    counts = np.frombuffer(raw, ">i4", rows, 16)
    at = 16 + 4 * rows
    indices = np.frombuffer(raw, ">i4", entries, at)
    values = np.frombuffer(raw, ">f8", entries, at + 4 * entries)
    starts = np.concatenate([[0], np.cumsum(counts)])
    return scipy.sparse.csr_matrix((values.astype(float), indices.astype(np.int32), starts), (rows, columns))


def read(model, mass, fixed):
    """`model`: any reduced model of the mesh; `mass`: what -export petsc wrote beside it; `fixed`: the set held."""
    with h5py.File(model) as file:
        geometry = file["bodies/body/geometry"]
        ids = geometry["vertex_ids"][:]
        free = np.ones((len(ids), 3), bool)
        free[geometry[f"sets/{fixed}/rows"][:]] = False
        report = report_of(file)[1]
        facts = {"mesh_checksum": text(file["provenance"].attrs["mesh_checksum"]),
                 "problem_checksum": text(file["provenance"].attrs["problem_checksum"]),
                 "vertices": int(report["vertices"]), "cells": int(report["cells"]),
                 "dofs": int(report["degrees_of_freedom"]),
                 "versions": "; ".join(f"{text(name).strip()} {text(value).strip()}" for name, value in
                                       file["provenance/versions"][:])}
    M = read_petsc(mass)
    if M.shape[0] != free.sum():
        raise ValueError(f"the mass matrix has {M.shape[0]} rows and the body {free.sum()} free components")
    return Body(ids, free.ravel(), M, facts)
