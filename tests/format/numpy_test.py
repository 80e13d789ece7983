"""A model as NumPy's users see it: checksums by the README's recipe, the view U, hard links, units."""
import os
import sys
import tempfile

try:
    import h5py
    import numpy as np
except ImportError:
    sys.exit(77)

import programs
from program import BIN

MASK = 2**64 - 1


def split_mix(x):
    x = (x + 0x9E3779B97F4A7C15) & MASK
    x = ((x ^ (x >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    x = ((x ^ (x >> 27)) * 0x94D049BB133111EB) & MASK
    return x ^ (x >> 31)


def checksum(array):
    total = 0
    for number in range(len(array)):
        data = array[number:number + 1].tobytes()  # of a text all its bytes, its zeros too
        data = data.ljust(-(-len(data) // 8) * 8, b"\0")
        value = split_mix(number)
        for at in range(0, len(data), 8):
            value = split_mix(value ^ int.from_bytes(data[at : at + 8], "little"))
        total = (total + value) & MASK
    return total


def check(name, item):
    if not isinstance(item, h5py.Dataset):
        return
    assert item.attrs["units"], name
    if item.is_virtual:
        return
    stored = np.empty(item.shape, item.dtype)
    if item.size:
        item.read_direct(stored)
    assert int(item.attrs["checksum"]) == checksum(stored), name


with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "model.h5")
    programs.run(BIN / "write_sample_model", path)
    with h5py.File(path) as file:
        assert file.attrs["format"] == b"ritz-model" and list(file.attrs["version"]) == [1, 4]
        file.visititems(check)
        basis = file["bodies/body/basis"]
        columns = [basis["columns"][name][...].ravel() for name in sorted(basis["columns"])]
        assert np.array_equal(basis["U"][...], np.column_stack(columns)) and abs(basis["U"][2, 0] - 0.5**0.5) < 1e-15
        for name, column in zip(file["VTKHDF/PointData"], columns, strict=True):
            seen = file["VTKHDF/PointData"][name]
            assert np.array_equal(seen[...].ravel(), (seen.attrs["factor"] * column).astype("f4")), name
            assert np.isclose(np.linalg.norm(seen[...], axis=1).max(), 0.1 * 3**0.5), name  # of a unit box's diagonal
        assert file["VTKHDF/Points"] == file["bodies/body/geometry/points"]
        assert file["provenance"].attrs["mesh_checksum"] == b"0123456789abcdef" and "VTKHDF" not in file["bodies/body"]
        assert dict(file["provenance/options"][...].tolist())[b"-modes"] == b"2"
    # The second body's own stands in its group.
    programs.run(BIN / "write_sample_model", path, "two-bodies")
    with h5py.File(path) as file:
        file.visititems(check)
        arm = file["bodies/arm%2Fupper"]
        assert np.array_equal(arm["basis/U"][...], file["bodies/body/basis/U"][...]) and arm["basis/U"][2, 0] != 0
        assert arm.attrs["problem_checksum"] == b"00000000000000bb"
        assert arm["VTKHDF/Points"] == arm["geometry/points"] and "figure_names" in arm["report"]
