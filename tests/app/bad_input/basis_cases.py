"""What the nonlinear stages refuse: sizes that do not fit together, and snapshots that are none."""
import os

import h5py
import numpy as np

from option_cases import bad

NUMBERS = 3 * 12  # of a displacement on WHOLE's mesh
GOOD = np.linspace(-1, 1, 2 * NUMBERS).reshape(2, NUMBERS)


def npy(array, fortran=False, cut=0, rows=None):
    """A .npy file; its last bytes cut off, or a header that promises `rows`."""
    def make(path):
        with open(path, "wb") as file:
            shape = array.shape if rows is None else (rows, *array.shape[1:])
            np.lib.format.write_array_header_1_0(
                file, {"descr": array.dtype.str, "fortran_order": fortran, "shape": shape})
            file.write(array.tobytes()[:array.nbytes - cut])
    return make


def hdf5(name, array):
    def make(path):
        with h5py.File(path, "w") as file:
            file[name] = array
    return make


def bomb(path):
    """Numbers by the terabyte, in a file of some hundred bytes."""
    with h5py.File(path, "w") as file:
        file.create_dataset("snapshots", (2**40, NUMBERS), "f8", chunks=(1, NUMBERS), fillvalue=1, compression="gzip")


def view_of_itself(path):
    with h5py.File(path, "w") as file:
        layout = h5py.VirtualLayout((2, NUMBERS), "f8")
        layout[...] = h5py.VirtualSource(".", "snapshots", (2, NUMBERS))
        file.create_virtual_dataset("snapshots", layout)


def elsewhere(path):
    with h5py.File(path, "w") as file:
        file.create_dataset("snapshots", (2, NUMBERS), "f8", external=[("numbers", 0, 16 * NUMBERS)])


def behind_a_link(path):
    with h5py.File(path, "w") as file:
        file["numbers"] = GOOD
        file["snapshots"] = h5py.SoftLink("/numbers")


def snapshots(name, make, *says, file="s.npy"):
    return bad(f"snapshots {name}", f"-snapshots {file} -basis 1", f"-snapshots {file}", *says, files={file: make})


def with_number(value):
    array = GOOD.copy()
    array[1, 5] = value
    return array


SIZES = [
    bad("derivatives of more modes than there are", "-derivatives 3", "-derivatives 3", "-modes 2"),
    bad("derivatives of fewer than no modes", "-derivatives -1", "-derivatives"),
    bad("a basis larger than its set", "-derivatives 2 -basis 6", "-basis 6", "only 5 "),
    bad("a basis larger than its modes", "-basis 3", "-basis 3", "only 2 "),
    bad("a basis too large for a polynomial", "-basis 151 -polynomial", "-basis 151", "150"),
    bad("a basis of nothing", "-basis 0", "-basis"),
    bad("two cuts", "-basis 2 -basis_tolerance .1", "-basis_tolerance", "-basis "),
    bad("a tolerance of 1", "-basis_tolerance 1", "-basis_tolerance"),
    bad("a tolerance that is NaN", "-basis_tolerance nan", "-basis_tolerance"),
    bad("a mode that is not there", "-basis_modes 1,7", "-basis_modes", "7"),
    bad("a mode 0", "-basis_modes 0,1", "-basis_modes"),
    bad("a mode twice", "-basis_modes 1,1", "-basis_modes"),
    bad("a mode in words", "-basis_modes first", "-basis_modes"),
    bad("more derivatives than chosen modes", "-basis_modes 2 -derivatives 2", "-derivatives 2", "only 1 "),
]

SNAPSHOTS = [
    bad("snapshots that are not there", "-snapshots none.npy", "none.npy", "no such file"),
    bad("snapshots, before modes that fail", "-snapshots s.npy -basis 1 -modes_eps_type power -modes_eps_max_it 1",
        "-snapshots s.npy", "two dimensions", files={"s.npy": npy(GOOD[0])}),
    bad("snapshots without a value", "-snapshots -quiet", "-snapshots"),
    snapshots("of the wrong length", npy(GOOD[:, :-3]), "33", "36"),
    snapshots("that hold NaN", npy(with_number(np.nan)), "snapshot 2", "finite"),
    snapshots("that are infinite", npy(with_number(np.inf)), "snapshot 2", "finite"),
    snapshots("in half precision", npy(GOOD.astype("f2")), "float64", "float32"),
    snapshots("of whole numbers", npy(GOOD.astype("i8")), "float64"),
    snapshots("column by column that hold NaN", npy(with_number(np.nan), fortran=True), "snapshot", "finite"),
    snapshots("of one dimension", npy(GOOD[0]), "two dimensions"),
    snapshots("of three dimensions", npy(GOOD.reshape(2, 12, 3)), "two dimensions"),
    snapshots("of three dimensions, the last of one", npy(GOOD.reshape(2, NUMBERS, 1)), "two dimensions"),
    snapshots("in the other order of bytes", npy(GOOD.astype(">f8")), "float64"),
    snapshots("that are longer than they say", npy(GOOD, rows=1), "longer"),
    snapshots("that are a pipe", os.mkfifo, "regular file"),
    snapshots("that are text", "1 2 3\n", ".npy"),
    snapshots("that are cut", npy(GOOD, cut=8), "snapshot 2"),
    snapshots("that promise 10^11 rows", npy(GOOD, rows=10**11), "ends"),
    snapshots("without a row", npy(GOOD[:0])),
    bad("snapshots that do not move", "-modes 0 -snapshots s.npy", "span nothing", files={"s.npy": npy(0 * GOOD)}),
    snapshots("that are no HDF5 file", "1 2 3\n", file="s.h5"),
    snapshots("under another name", hdf5("states", GOOD), "/snapshots", file="s.h5"),
    snapshots("of HDF5 of the wrong length", hdf5("snapshots", GOOD[:, 1:]), "35", "36", file="s.h5"),
    snapshots("of HDF5 of words", hdf5("snapshots", np.full((1, NUMBERS), b"a")), file="s.h5"),
    snapshots("of HDF5 that are not there", bomb, "larger", file="s.h5"),
    snapshots("of HDF5 that are a view of themselves", view_of_itself, "view", file="s.h5"),
    snapshots("of HDF5 in another file", elsewhere, "other files", file="s.h5"),
    snapshots("of HDF5 behind a link", behind_a_link, "link", file="s.h5"),
    snapshots("of HDF5 of three dimensions", hdf5("snapshots", GOOD.reshape(2, 12, 3)), "two dimensions", file="s.h5"),
]

SCENE = "[static]\nsteps = 1\n"
PUSHED = "gravity = [0, 0, -1]\n" + SCENE


def accuracy(name, options, *says, scene=PUSHED):
    return bad(f"an accuracy {name}", options, *says, files={"scene.toml": scene})


ACCURACY = [
    accuracy("without a scene", "-accuracy 1e-2", "-accuracy_scene"),
    accuracy("of no size", "-accuracy_scene scene.toml", "-accuracy "),
    accuracy("of 0", "-accuracy 0 -accuracy_scene scene.toml", "-accuracy", "1e-6"),
    accuracy("of 1", "-accuracy 1 -accuracy_scene scene.toml", "-accuracy", "0.5"),
    accuracy("that is NaN", "-accuracy nan -accuracy_scene scene.toml", "-accuracy"),
    accuracy("and a size", "-basis 3 -accuracy 1e-2 -accuracy_scene scene.toml", "-basis"),
    accuracy("and derivatives", "-derivatives 1 -accuracy 1e-2 -accuracy_scene scene.toml", "-derivatives"),
    accuracy("in a scene that is not there", "-accuracy 1e-2 -accuracy_scene none.toml", "none.toml"),
    accuracy("in a scene without loads", "-accuracy 1e-2 -accuracy_scene scene.toml", "do not push", scene=SCENE),
    accuracy("of a free body", "-fix none -accuracy 1e-2 -accuracy_scene scene.toml", "rigid motions"),
]

CASES = [*SIZES, *SNAPSHOTS, *ACCURACY]
