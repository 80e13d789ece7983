"""Models that are none, or no longer, as ritz-run, ritz-inspect and -reuse meet them."""
import h5py
import numpy as np

from option_cases import WHOLE
from runner import Case, written

SCENE = """
[time]
step = 1e-3
end = 1e-2
[[load]]
set = "xmax"
total = [0, 0, 1]
"""


MODEL = written("model.h5", "ritz-reduce", *WHOLE)


def changed(change):
    """The model with `change` done to it through HDF5."""
    def make(path):
        path.write_bytes(MODEL)
        with h5py.File(path, "r+") as file:
            change(file)
    return make


def without(name):
    return changed(lambda file: file.__delitem__(name))


def replace(name, value):
    def change(file):
        attributes = dict(file[name].attrs)
        del file[name]
        file[name] = value
        file[name].attrs.update(attributes)
    return changed(change)


def split_mix(x):
    x = x + np.uint64(0x9E3779B97F4A7C15)
    x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return x ^ (x >> np.uint64(31))


def checksum(array):
    """As src/format/README.md has it, of rows of whole words."""
    rows = np.ascontiguousarray(array).view(np.uint8).reshape(len(array), -1)
    rows = np.pad(rows, ((0, 0), (0, -rows.shape[1] % 8))).view(np.uint64)
    with np.errstate(over="ignore"):
        value = split_mix(np.arange(len(array), dtype=np.uint64))
        for word in rows.T:
            value = split_mix(value ^ word)
        return value.sum(dtype=np.uint64)


def stored(name, make):
    """make(array) in the place of a dataset, with the checksum that it has."""
    def change(file):
        attributes = dict(file[name].attrs)
        array = np.asarray(make(file[name][()]))
        del file[name]
        file[name] = array
        file[name].attrs.update(attributes | {"checksum": checksum(array)})
    return changed(change)


def at(index, value):
    def make(array):
        array.flat[index] = value
        return array
    return make


def view_of_itself(name):
    def change(file):
        shape, units = file[name].shape, file[name].attrs["units"]
        layout = h5py.VirtualLayout(shape, "f8")
        layout[...] = h5py.VirtualSource(".", name, shape)
        del file[name]
        file.create_virtual_dataset(name, layout).attrs["units"] = units
    return changed(change)


def without_heap(path):
    """Zeros in the heap that the view basis/U needs, for which HDF5 has no checksum."""
    damaged = bytearray(MODEL)
    at = damaged.index(b"GCOL")
    damaged[at + 16:at + 512] = bytes(496)
    path.write_bytes(damaged)


def set_attribute(name, value):
    return changed(lambda file: file.attrs.modify(name, value))


def flipped(name):
    """One bit of one number, on the disk."""
    def make(path):
        path.write_bytes(MODEL)
        with h5py.File(path) as file:
            at = file[name].id.get_offset()
        damaged = bytearray(MODEL)
        damaged[at + 3] ^= 1
        path.write_bytes(damaged)
    return make


def half_written(path):
    path.write_bytes(MODEL[:len(MODEL) // 2] + bytes(len(MODEL) - len(MODEL) // 2))


BODY = "bodies/body/"
DAMAGED = [
    ("text in place of a model", "not HDF5", "not an HDF5 file"),
    ("an empty model", "", "not an HDF5 file"),
    ("a model cut in half", MODEL[:len(MODEL) // 2], "truncated"),
    ("a model cut by a byte", MODEL[:-1], "truncated"),
    ("a model whose second half was not written", half_written, "model.h5"),
    ("an HDF5 file of something else", lambda path: h5py.File(path, "w").close(), "not a ritz model"),
    ("a model of another name", set_attribute("format", b"ritz-motion"), "not a ritz model"),
    ("a model of version 9", set_attribute("version", [9, 0]), "9.0"),
    ("a model without bodies", without("bodies"), "bod"),
    ("a model without a basis", without(BODY + "basis"), "basis"),
    ("a model without points", without(BODY + "geometry/points"), "points"),
    ("a model of misshapen points", replace(BODY + "geometry/points", [[0.0, 1.0]]), "points"),
    ("a model of one eigenvalue alone", replace(BODY + "modes/eigenvalues", b"x"), "eigenvalues", "single value"),
    ("a model of a word for eigenvalues", replace(BODY + "modes/eigenvalues", "word"), "eigenvalues", "single value"),
    ("a model of a word for regions", replace(BODY + "geometry/materials/regions", "word"), "regions", "single value"),
    ("a model of too few eigenvalues", replace(BODY + "modes/eigenvalues", [1.0]), "modes"),
    ("a model of longer columns", stored(BODY + "basis/columns/0001", lambda a: np.concatenate([a] * 60)), "basis"),
    ("a model of NaN in U", stored(BODY + "basis/columns/0002", at(15, np.nan)), "columns/0002", "finite"),
    ("a model of a cell cut short", stored(BODY + "geometry/cells/types", at(0, 24)), "cells/offsets", "not 10"),
    ("a model of a negative eigenvalue", stored(BODY + "modes/eigenvalues", at(0, -1)), "modes", "eigenvalue"),
    ("a model of a load that is a view of itself", view_of_itself(BODY + "loads/xmax/total"), "xmax/total", "view"),
    ("a model of a damaged heap", without_heap, "basis/U", "damaged"),
    ("a model of a link to elsewhere",
     changed(lambda file: (file.move("report", "kept"), file.__setitem__("report", h5py.SoftLink("/kept")))), "report"),
    ("a model of damaged eigenvalues", flipped(BODY + "modes/eigenvalues"), "eigenvalues", "checksum"),
]

RUN = ["model.h5", "--scene", "scene.toml"]
CASES = []
for name, content, *says in DAMAGED:
    models = {"model.h5": content}
    CASES.append(Case(f"ritz-run: {name}", RUN, ["model.h5", *says], models | {"scene.toml": SCENE}, "ritz-run"))
    CASES.append(Case(f"ritz-inspect: {name}", ["model.h5", "--check"], ["model.h5", *says], models, "ritz-inspect"))

CASES += [
    Case("ritz-inspect --check: a damaged basis", ["model.h5", "--check"], ["basis", "checksum"],
         {"model.h5": flipped(BODY + "basis/columns/0001")}, "ritz-inspect"),
    Case("ritz-inspect: a model without points", ["model.h5"], ["points", "missing"],
         {"model.h5": without(BODY + "geometry/points")}, "ritz-inspect"),
    Case("ritz-inspect: half a model", ["model.h5"], ["model.h5"], {"model.h5": half_written}, "ritz-inspect"),
    Case("ritz-inspect: no model", ["model.h5"], ["model.h5"], program="ritz-inspect"),
    Case("ritz-inspect: a folder", ["model.h5"], ["model.h5", "folder"], {"model.h5/a": ""}, "ritz-inspect"),
    Case("ritz-inspect: a path through a file", ["a/model.h5"], ["a/model.h5"], {"a": ""}, "ritz-inspect"),
    Case("ritz-inspect: a half-written model", ["model.h5.part"], ["half-written"], {"model.h5.part": MODEL}, "ritz-inspect"),
    Case("ritz-inspect: an unknown option", ["model.h5", "--chek"], ["--chek", "--check"], {"model.h5": MODEL}, "ritz-inspect"),
    Case("ritz-inspect: nothing to inspect", [], ["model"], program="ritz-inspect"),
    Case("ritz-run: no model", RUN, ["model.h5"], {"scene.toml": SCENE}, "ritz-run"),
    Case("ritz-run: no scene", RUN, ["scene.toml"], {"model.h5": MODEL}, "ritz-run"),
    Case("ritz-run: an unknown option", [*RUN, "--outptu", "a.h5"], ["--outptu", "--output"],
         {"model.h5": MODEL, "scene.toml": SCENE}, "ritz-run"),
    Case("ritz-run: a set that is not there", RUN, ["xmxa", "xmax"],
         {"model.h5": MODEL, "scene.toml": SCENE.replace("xmax", "xmxa")}, "ritz-run"),
    Case("ritz-run: a step of 0", RUN, ["scene.toml", "step"],
         {"model.h5": MODEL, "scene.toml": SCENE.replace("1e-3", "0")}, "ritz-run"),
    Case("ritz-run: an output in a folder that is not there", [*RUN, "--output", "a/motion.h5"], ["a/motion.h5"],
         {"model.h5": MODEL, "scene.toml": SCENE}, "ritz-run"),
]

REUSE = [*WHOLE, "-reuse", "old.h5"]
CASES += [
    Case("-reuse of no file", REUSE, ["old.h5"]),
    Case("-reuse of text", REUSE, ["old.h5", "not an HDF5 file"], {"old.h5": "not HDF5"}),
    Case("-reuse of a folder", REUSE, ["old.h5", "folder"], {"old.h5/a": ""}),
    Case("-reuse of half a model", REUSE, ["old.h5", "truncated"], {"old.h5": MODEL[:len(MODEL) // 2]}),
    Case("-reuse of a model whose second half was not written", REUSE, ["old.h5"], {"old.h5": half_written}),
    Case("-reuse of a later version", REUSE, ["old.h5", "9.0"], {"old.h5": set_attribute("version", [9, 0])}),
    Case("-reuse of a model of one eigenvalue alone", REUSE, ["old.h5", "single value"],
         {"old.h5": replace(BODY + "modes/eigenvalues", "word")}),
    Case("-reuse of a mass that is none", REUSE, ["old.h5", "mass"],
         {"old.h5": stored(BODY + "inertia/gram", at(0, -1))}),
    Case("-reuse of a basis that is not orthonormal", REUSE, ["old.h5", "UᵀMU"],
         {"old.h5": stored(BODY + "inertia/gram", lambda a: a + 1e-9 * np.diag([0] * 4 + [1] * (len(a) - 4)))}),
    Case("-reuse of NaN in U", REUSE, ["old.h5", "columns/0001", "finite"],
         {"old.h5": stored(BODY + "basis/columns/0001", at(15, np.nan))}),
    Case("-reuse of a damaged basis", REUSE, ["old.h5", "checksum"], {"old.h5": flipped(BODY + "basis/columns/0001")}),
]
