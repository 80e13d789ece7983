"""Mesh files that are damaged, impossible or not meshes at all; and odd ones that must work."""
import os

from meshes import INP, MSH2, MSH2_BINARY, MSH4, VEG, VTU
from runner import Case

MATERIAL = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000"]
OUTPUTS = {"model.h5", "model.hdf", "frequencies.csv"}


def words_for(file):
    return ["-mesh", file, "-modes", "2", *MATERIAL]


def bad(name, file, content, *says):
    """A wrong mesh file: the sentence names it."""
    return Case(name, words_for(file), [file, *says], {file: content})


def good(name, file, content, *words):
    return Case(name, [*words_for(file), *words], [], {file: content}, code=0, leaves=OUTPUTS)


def replaced(text, old, new):
    assert old in text, old
    return text.replace(old, new, 1)


def upto(content, mark):
    """The file, cut off in the middle of `mark`."""
    return content[:content.index(mark) + len(mark) // 2]


def crlf(text):
    return text.replace("\n", "\r\n").encode()


TRUNCATED = [
    bad("msh 2.2 cut in a coordinate", "m.msh", upto(MSH2, "3 0 1 0"), "truncated"),
    bad("msh 2.2 cut in the cells", "m.msh", upto(MSH2, "2 4 2 1 1 1 2 3 4"), ":20"),
    bad("msh 2.2 cut in its header", "m.msh", "$MeshFo"),
    bad("msh 2.2 without its end", "m.msh", replaced(MSH2, "$EndElements\n", "")),
    bad("msh 2.2 without cells", "m.msh", upto(MSH2, "$Elements")),
    bad("msh 2.2 binary cut in a coordinate", "m.msh", MSH2_BINARY[:100], "truncated"),
    bad("msh 2.2 binary cut in a cell", "m.msh", MSH2_BINARY[:-30], "truncated"),
    bad("msh 4.1 cut in the vertices", "m.msh", upto(MSH4, "1 1 1\n$EndNodes")),
    bad("msh 4.1 cut in the cells", "m.msh", upto(MSH4, "3 1 4 2")),
    bad("veg cut in the vertices", "m.veg", upto(VEG, "4 0 0 1")),
    bad("veg cut in the cells", "m.veg", upto(VEG, "2 2 3 4 5")),
    bad("inp cut in a cell", "m.inp", upto(INP, "2, 2, 3, 4, 5")),
    bad("inp cut before the cells", "m.inp", upto(INP, "*ELEMENT")),
    bad("vtu cut in an array", "m.vtu", upto(VTU, "0 1 2 3")),
    bad("vtu cut in a tag", "m.vtu", upto(VTU, "</UnstructuredGrid>")),
    bad("empty msh", "m.msh", "", "empty"),
    bad("msh of zeros", "m.msh", bytes(200)),
]

HEADERS = [
    bad("version 1 of msh", "m.msh", "$NOD\n1\n1 0 0 0\n$ENDNOD\n"),
    bad("version 3 of msh", "m.msh", replaced(MSH2, "2.2 0 8", "3.0 0 8"), ":2", "version 3"),
    bad("version 4.0 of msh", "m.msh", replaced(MSH4, "4.1 0 8", "4.0 0 8"), ":2", "version 4"),
    bad("version 9 of msh", "m.msh", replaced(MSH4, "4.1 0 8", "9.1 0 8"), ":2", "version 9.1"),
    bad("version x of msh", "m.msh", replaced(MSH2, "2.2 0 8", "x 0 8"), ":2"),
    bad("a binary msh that is text", "m.msh", replaced(MSH2, "2.2 0 8", "2.2 1 8")),
    bad("a msh that is a picture", "m.msh", b"\x89PNG\r\n\x1a\n" + bytes(range(256))),
    bad("a vtu of another type", "m.vtu", VTU.replace("UnstructuredGrid", "ImageData"), "UnstructuredGrid"),
    bad("a vtu that is no XML", "m.vtu", "vertices 5\n"),
    bad("an ending of no format", "m.stl", "solid\n", ".msh"),
]

COUNTS = [
    bad("a huge count of vertices", "m.msh", replaced(MSH2, "$Nodes\n5", "$Nodes\n999999999999")),
    bad("a count beyond 64 bits", "m.msh", replaced(MSH2, "$Nodes\n5", "$Nodes\n99999999999999999999999"), ":10"),
    bad("a negative count of vertices", "m.msh", replaced(MSH2, "$Nodes\n5", "$Nodes\n-5"), ":10", "negative"),
    bad("a negative count of cells", "m.msh", replaced(MSH2, "$Elements\n3", "$Elements\n-3"), ":18", "negative"),
    bad("too small a count of cells", "m.msh", replaced(MSH2, "$Elements\n3", "$Elements\n1")),
    bad("a huge count in msh 4.1", "m.msh", replaced(MSH4, "$Nodes\n1 5 1 5", "$Nodes\n1 5000000000 1 5")),
    bad("a huge block in msh 4.1", "m.msh", replaced(MSH4, "3 1 0 5", "3 1 0 5000000000")),
    bad("a negative count in veg", "m.veg", replaced(VEG, "5 3 0 0", "-5 3 0 0"), ":2"),
    bad("a huge count in veg", "m.veg", replaced(VEG, "5 3 0 0", "4000000000 3 0 0")),
    bad("a huge count in vtu", "m.vtu", replaced(VTU, 'NumberOfPoints="5"', 'NumberOfPoints="5000000000"')),
    bad("a negative count in vtu", "m.vtu", replaced(VTU, 'NumberOfCells="2"', 'NumberOfCells="-2"')),
]

NUMBERS = [
    bad("two vertices of one number", "m.msh", replaced(MSH2, "3 0 1 0", "2 0 1 0"), "2"),
    bad("two vertices of one number in inp", "m.inp", replaced(INP, "3, 0, 1, 0", "2, 0, 1, 0"), "2"),
    bad("two cells of one number in inp", "m.inp", replaced(INP, "2, 2, 3, 4, 5", "1, 2, 3, 4, 5"), "1"),
    bad("a cell of a vertex that is not there", "m.msh", replaced(MSH2, "2 3 4 5\n", "2 3 4 99\n"), "99"),
    bad("the same in msh 4.1", "m.msh", replaced(MSH4, "2 2 3 4 5", "2 2 3 4 99"), "99"),
    bad("the same in veg", "m.veg", replaced(VEG, "2 2 3 4 5", "2 2 3 4 99"), "99"),
    bad("the same in inp", "m.inp", replaced(INP, "2, 2, 3, 4, 5", "2, 2, 3, 4, 99"), "99"),
    bad("the same in vtu", "m.vtu", replaced(VTU, "1 2 3 4\n", "1 2 3 98\n"), "98"),
    bad("a cell that uses a vertex twice", "m.msh", replaced(MSH2, "2 3 4 5\n", "2 3 4 4\n")),
    bad("offsets of vtu that go back", "m.vtu", replaced(VTU, ">4 8<", ">8 4<")),
    bad("a coordinate that is NaN", "m.msh", replaced(MSH2, "3 0 1 0", "3 0 nan 0"), ":13"),
    bad("a coordinate that is infinite", "m.inp", replaced(INP, "3, 0, 1, 0", "3, 0, 1e999, 0"), ":4"),
    bad("a coordinate that is NaN in vtu", "m.vtu", replaced(VTU, "0 1 0\n", "0 nan 0\n")),
    bad("a coordinate that is a word", "m.veg", replaced(VEG, "3 0 1 0", "3 0 one 0"), ":5"),
]

CELLS = [
    bad("a prism of 18", "m.msh", replaced(MSH2, "2 4 2 1 1 1 2 3 4", "2 13 2 1 1 1 2 3 4 5 1"), ":20", "prism with 18"),
    bad("a shell in inp", "m.inp", replaced(INP, "C3D4", "S4R"), "S4R"),
    bad("a tie in inp", "m.inp", INP + "*TIE, NAME=T\nA, B\n", ":20", "*TIE", "-ignore TIE"),
    bad("a keyword of no program", "m.inp", INP + "*GLUE, NAME=T\nA, B\n", ":20", "*GLUE", "-ignore GLUE"),
    bad("a preload of the frequency step", "m.inp", INP + "*STEP\n*STATIC\n*CLOAD\n5, 1, 1.\n*END STEP\n"
        "*STEP, PERTURBATION\n*FREQUENCY\n2\n*END STEP\n", ":25", "PERTURBATION"),
    Case("one keyword ignored of two", [*words_for("m.inp"), "-ignore", "TIE"], ["m.inp:22", "*EQUATION"],
         {"m.inp": INP + "*TIE, NAME=T\nA, B\n*EQUATION\n2\n1, 1, 1., 4, 1, 1.\n"}),
    bad("a polyhedron in vtu", "m.vtu", replaced(VTU, ">10 10<", ">10 42<"), "42"),
    bad("an unknown cell in veg", "m.veg", replaced(VEG, "TET", "PRISM"), "PRISM"),
    bad("surfaces alone", "m.msh", replaced(MSH2, "2 4 2 1 1 1 2 3 4\n3 4 2 1 1 2 3 4 5", "2 2 2 7 1 1 2 4\n3 2 2 7 1 1 3 4")),
    Case("an inverted cell", words_for("m.msh"), ["cell 3", "inverted"], {"m.msh": replaced(MSH2, "2 3 4 5\n", "3 2 4 5\n")}),
    Case("a cell twice", words_for("m.msh"), ["cells 2 and 3", "same corners"], {"m.msh": replaced(MSH2, "2 3 4 5\n", "1 2 3 4\n")}),
    Case("an inp that fixes everything", words_for("m.inp"), ["*BOUNDARY", "nothing is left"],
         {"m.inp": replaced(INP, "FOOT, 1, 3", "BLOCK, 1, 3")}),
    Case("a flat cell", words_for("m.msh"), ["cell 2", "flat"], {"m.msh": replaced(MSH2, "4 0 0 1", "4 .5 .5 0")}),
]

FILES = [
    Case("no such mesh", words_for("m.msh"), ["m.msh", "no such file"]),
    Case("a folder for a mesh", words_for("m.msh"), ["m.msh", "directory"], {"m.msh/a": ""}),
    Case("a path through a file", words_for("a/m.msh"), ["a/m.msh"], {"a": ""}),
    Case("a device for a mesh", words_for("m.msh"), ["m.msh"], {"m.msh": lambda p: p.symlink_to("/dev/zero")}),
    Case("a pipe that nobody feeds", words_for("m.msh"), ["m.msh"], {"m.msh": os.mkfifo}),
    Case("a link in a circle", words_for("m.msh"), ["m.msh"], {"m.msh": lambda p: p.symlink_to("m.msh")}),
    bad("a veg that includes what is not there", "m.veg", "*INCLUDE other.veg\n" + VEG, "other.veg"),
    bad("a veg that includes itself", "m.veg", "*INCLUDE m.veg\n" + VEG),
    bad("an inp that sets what is not there", "m.inp", replaced(INP, "FOOT, 1, 3", "FEET, 1, 3"), "FEET"),
    bad("an inp of an unknown material", "m.inp", replaced(INP, "MATERIAL=STEEL", "MATERIAL=STEAL"), "STEAL"),
]

ODD = [
    good("two tetrahedra in msh 2.2", "m.msh", MSH2),
    good("binary msh 2.2", "m.msh", MSH2_BINARY),
    good("msh 4.1", "m.msh", MSH4),
    good("vtu", "m.vtu", VTU),
    good("msh 2.2 with CRLF", "m.msh", crlf(MSH2), "-fix", "bottom"),
    good("msh 4.1 with CRLF", "m.msh", crlf(MSH4)),
    good("veg with CRLF", "m.veg", crlf(VEG)),
    good("inp with CRLF", "m.inp", crlf(INP)),
    good("inp with a comma after every keyword", "m.inp",
         "".join(line + (",\n" if line.startswith("*") else "\n") for line in INP.splitlines())),
    good("vtu with CRLF", "m.vtu", crlf(VTU)),
]

CASES = [*TRUNCATED, *HEADERS, *COUNTS, *NUMBERS, *CELLS, *FILES, *ODD]
