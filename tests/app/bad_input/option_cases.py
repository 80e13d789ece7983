"""Options that are misspelt, of the wrong kind, impossible, or at odds with the mesh."""
import os

from mesh_cases import OUTPUTS
from meshes import INP, MSH2, VEG
from runner import Case

BOX = ["-mesh", "box:1,1,1/2,1,1/tet4"]
MATERIAL = ["-material_young", "1e6", "-material_poisson", ".3", "-material_density", "1000"]
WHOLE = [*BOX, *MATERIAL, "-fix", "xmin", "-modes", "2"]


def bad(name, words, *says, files=None, **more):
    """A wrong option on top of a command line that is whole; PETSc takes the last of two."""
    return Case(name, [*WHOLE, *words.split()], says, files or {}, **more)


def option_file(name, content, *says, file="a.opts"):
    return bad(name, f"-options_file {file}", *says, files={file: content})


UNKNOWN = [
    bad("-modees", "-modees 3", "-modees", "-modes?"),
    bad("-fixx", "-fixx xmin", "-fixx", "-fix?"),
    bad("-outptu", "-outptu a.h5", "-outptu", "-output?"),
    bad("-matreial_young", "-matreial_young 1", "-matreial_young", "-material_young?"),
    bad("-material_body_yuong", "-material_body_yuong 1", "-material_body_yuong"),
    bad("a material of a region without a name", "-material__young 1", "-material__young"),
    bad("-modes_eps_tolx", "-modes_eps_tolx 1e-3", "-modes_eps_tolx", "-modes_eps_tol?"),
    bad("-solve_ksp_typo", "-solve_ksp_typo cg", "-solve_ksp_typo", "-solve_ksp_type?"),
    bad("-solve_ksp_viewx", "-solve_ksp_viewx", "-solve_ksp_viewx", "-solve_ksp_view?"),
    bad("-solve_mat_mumps_incntl_14", "-solve_mat_mumps_incntl_14 30", "-solve_mat_mumps_incntl_14"),
    bad("-modes_st_pc_typ", "-modes_st_pc_typ lu", "-modes_st_pc_typ", "-modes_st_pc_type?"),
    bad("two dashes", "--modes 3", "--modes"),
    bad("-options_fiel", "-options_fiel a.opts", "-options_fiel", "-options_file?"),
    bad("-quite", "-quite", "-quite", "-quiet?"),
]

SOLVERS = [
    bad("SLEPc's options beside the other solver", "-solver iterative -modes_eps_tol 1e-9", "-solver iterative", "-modes_eps_"),
    bad("a multigrid of another kind", "-multigrid_pc_type hypre", "-multigrid_pc_type", "gamg"),
    bad("a smoother of the multigrid", "-multigrid_mg_levels_ksp_type richardson", "-multigrid_mg_levels_ksp_type",
        "no effect"),
    bad("an eigensolver that is not there", "-modes_eps_type foo", "foo"),
    bad("modes by interval", "-modes_eps_interval 0,1e9", "-modes_eps_interval", "-modes K"),
    bad("an eigensolver that takes no shift-invert", "-modes_eps_type lobpcg", "smallest real"),
    bad("the largest eigenvalues under shift-invert", "-modes_eps_largest_magnitude", "under -modes_"),
    bad("the smallest eigenvalues under shift-invert", "-modes_eps_smallest_real", "under -modes_"),
    bad("a number of iterations in words", "-modes_eps_max_it many", "many"),
    bad("a linear solver that is not there", "-solve_ksp_type foo", "foo"),
    bad("a factorization that is not there", "-solve_pc_factor_mat_solver_type foo", "foo"),
    bad("a preconditioner in place of a factorization", "-solve_pc_type jacobi", "-solve_"),
]

WORDS = [
    Case("a word where an option should be", ["beam.msh"], ["'beam.msh'", "-mesh beam.msh"]),
    bad("a second value", "-modes 2 3", "'3'"),
    bad("a word behind a flag", "-surface_only yes please", "'please'"),
    Case("no options at all", [], ["-mesh"]),
    Case("-mesh without a value", ["-mesh"], ["-mesh"]),
    bad("-modes without a value", "-modes -quiet", "-modes", "number"),
    bad("-fix without a value", "-fix -quiet", "-fix"),
]

KINDS = [
    bad("no modes of a body that is held", "-modes 0", "-modes 0", "empty"),
    bad("no modes, in a plan", "-modes 0 -fix xmin,xmax -plan", "-modes 0", "-snapshots"),
    bad("2.5 modes", "-modes 2.5", "-modes 2.5", "whole number"),
    bad("five modes", "-modes five", "-modes five"),
    bad("-3 modes", "-modes -3", "-modes -3", "at least 0"),
    bad("far too many modes", "-modes 99999999999999", "-modes 99999999999999"),
    bad("blocks of 0", "-modes_block 0", "-modes_block 0"),
    bad("a tolerance of 1", "-modes_tolerance 1", "-modes_tolerance 1"),
    bad("-solver foo", "-solver foo", "-solver foo", "auto, direct, iterative"),
    bad("-solver interative", "-solver interative", "'iterative'"),
    bad("-partitioner metsi", "-partitioner metsi", "'metis'"),
    bad("-export matlab", "-export matlab", "-export matlab"),
    bad("-plan perhaps", "-plan perhaps", "-plan perhaps"),
    bad("-units mm", "-units mm", "-units mm", "mm-t-s"),
    bad("-units mm-stone-s", "-units mm-stone-s", "'stone'"),
    bad("-units m-kg-s-K", "-units m-kg-s-K", "-units m-kg-s-K"),
]


def box(name, text, *says):
    return Case(name, ["-mesh", text, *MATERIAL], [text, *says])


BOXES = [
    box("a box of two lengths", "box:1,1/1,1,1/tet4"),
    box("a box of four counts", "box:1,1,1/1,1,1,1/tet4"),
    box("a box without a type", "box:1,1,1/1,1,1", "box:LX,LY,LZ/NX,NY,NZ/tet4"),
    box("a box of pyramids", "box:1,1,1/1,1,1/pyramid5", "'pyramid5'", "hex8"),
    box("a box of negative length", "box:-1,1,1/1,1,1/tet4", "positive"),
    box("a box of length NaN", "box:nan,1,1/1,1,1/tet4"),
    box("a box of no cells", "box:1,1,1/0,1,1/tet4", "positive"),
    box("a box of half a cell", "box:1,1,1/.5,1,1/tet4", "'.5'"),
    box("a box of too many cells", "box:1,1,1/100000,100000,100000/tet4", "coarser"),
    box("a box of more than 64 bits", "box:1,1,1/1,1,99999999999999999999/tet4"),
    box("a box of nothing", "box:", "box:LX,LY,LZ/NX,NY,NZ/tet4"),
]

SUPPORTS = [
    bad("a set that is not there", "-fix xmni", "-fix xmni", "'xmin'"),
    bad("one of two sets", "-fix xmin,ymx:z", "'ymx'", "'ymax'"),
    bad("a set's component q", "-fix xmin:xq", "'xq'", "xyz"),
    bad("an empty name", "-fix xmin,,xmax", "-fix xmin,,xmax"),
    bad("none and more", "-fix none,xmin", "'none'"),
    bad("a box of four numbers", "-fix box:0,1,0,1", "box:x0,x1,y0,y1,z0,z1"),
    bad("a box with a word", "-fix box:0,1,0,one,0,1", "'one'"),
    bad("a box inside out", "-fix box:1,0,0,1,0,1", "inside out"),
    bad("a box of no vertex", "-fix box:5,6,5,6,5,6", "no vertex"),
    bad("everything fixed", "-fix box:0,1,0,1,0,1", "-fix", "nothing is left"),
    bad("a list of vertices for a box", "-fix a.bou", "a.bou", files={"a.bou": "1,2,3\n"}),
    bad("a list that is not there", "-mesh m.veg -fix a.bou", "a.bou", files={"m.veg": VEG}),
    bad("a list of words", "-mesh m.veg -fix a.bou", "a.bou:1", files={"m.veg": VEG, "a.bou": "one,two\n"}),
    bad("a list beyond the mesh", "-mesh m.veg -fix a.bou", "a.bou:2", "9", files={"m.veg": VEG, "a.bou": "1,\n9\n"}),
    bad("a list from 0 on", "-mesh m.veg -fix a.bou", "a.bou:1", "0", files={"m.veg": VEG, "a.bou": "0,1\n"}),
    bad("a mesh without sets", "-mesh m.msh -fix foot", "-fix foot",
        files={"m.msh": MSH2.replace('2\n2 7 "bottom"\n3 1 "block"', "0").replace(" 7 1 1 2 3", " 0 1 1 2 3")}),
]

MATERIALS = [
    Case("no material at all", BOX, ["'body'", "-material_young"]),
    Case("no density", [*BOX, *MATERIAL[:4]], ["'body'", "-material_density"]),
    Case("one of two regions without a material", ["-mesh", "m.inp"], ["'default'", "has no material", "-material_"],
         {"m.inp": INP.replace("2, 2, 3, 4, 5\n", "*ELEMENT, TYPE=C3D4, ELSET=REST\n2, 2, 3, 4, 5\n")}),
    bad("a region that is not there", "-material_bdoy_young 1", "'bdoy'", "'body'"),
    bad("no stiffness", "-material_young 0", "Young", "'body'", "positive"),
    bad("a negative stiffness", "-material_young -1e6", "Young", "positive"),
    bad("a stiffness that is NaN", "-material_young nan", "-material_young nan"),
    bad("an infinite stiffness", "-material_young inf", "-material_young inf"),
    bad("a stiffness in words", "-material_young steel", "-material_young steel"),
    bad("a stiffness with its unit", "-material_young 210GPa", "-material_young 210GPa"),
    bad("a Poisson's ratio of a half", "-material_poisson .5", "Poisson", "0.5"),
    bad("a Poisson's ratio of -1", "-material_poisson -1", "Poisson", "-1"),
    bad("a region's Poisson's ratio of .7", "-material_body_poisson .7", "Poisson", "0.7"),
    bad("no mass", "-material_density 0", "density", "positive"),
    bad("a mass beyond numbers", "-material_density 1e400", "-material_density 1e400"),
    bad("a law that is not there", "-material_law neohooke", "neohooke", "neo-hookean"),
    bad("a cubature of a law that has a polynomial", "-derivatives 2 -cubature 4", "-cubature", "-polynomial"),
    bad("a cubature of more cells than there are", "-material_law neo-hookean -derivatives 2 -cubature 5000", "5000", "12"),
    bad("a region's law that is not there", "-material_body_law neohooke", "neohooke", "neo-hookean"),
]

OUTPUT = [
    bad("an output in a folder that is not there", "-output a/b/model.h5", "-output a/b/model.h5", "folder"),
    bad("an output that is a folder", "-output a", "-output a", "folder", files={"a/kept": "1"}),
    bad("an output over a snapshot file", "-output a.npy -snapshots a.npy -basis 2", "-output a.npy", "overwrite",
        files={"a.npy": "1"}),
    bad("an output through a file", "-output a/model.h5", "-output a/model.h5", files={"a": "1"}),
    bad("an output to a device", "-output /dev/null", "-output /dev/null", "a device"),
    bad("an output to a named pipe", "-output a", "-output a", "a named pipe", files={"a": os.mkfifo}),
    bad("an output to a link", "-output a", "-output a", "a symbolic link",
        files={"b": "1", "a": lambda path: path.symlink_to("b")}),
    bad("an output to a link to nothing", "-output a", "-output a", "a symbolic link",
        files={"a": lambda path: path.symlink_to("b")}),
    bad("a table where a folder stands", "-output a.h5", "a.frequencies.csv", "is a folder",
        files={"a.frequencies.csv/kept": "1"}),
    bad("a matrix where a folder stands", "-export petsc", "model_M.bin", "is a folder", files={"model_M.bin/kept": "1"}),
    bad("an output of another name of its snapshots", "-output b -snapshots a.npy -basis 2", "overwrite", "-snapshots",
        files={"a.npy": "1", "b": lambda path: path.hardlink_to(path.parent / "a.npy")}),
    bad("an output over its options", "-output a.opts -options_file a.opts", "-output a.opts", "overwrite",
        files={"a.opts": "-modes 3\n"}),
    bad("an output over what its mesh includes", "-mesh a.inp -output b.inp", "b.inp", "overwrite",
        files={"a.inp": "*INCLUDE, INPUT=b.inp\n", "b.inp": INP}),
    bad("a table over its mesh", "-mesh a.frequencies.csv -output a.h5", "a.frequencies.csv", "overwrite",
        files={"a.frequencies.csv": INP}),
    bad("an output whose name is too long", f"-output {250 * 'a'}.h5", "the name is too long"),
    bad("an output whose table's name is too long", f"-output {250 * 'a'}", "the name is too long"),
    bad("an output in a place that takes no files", "-output /proc/model.h5", "/proc/model.h5"),
    bad("an earlier output", "-fix xmni", "-fix xmni", files={"model.h5": "earlier", "frequencies.csv": "earlier"}),
]

OPTION_FILES = [
    bad("no such options file", "-options_file a.opts", "a.opts"),
    bad("a folder of options", "-options_file a", "-options_file a", files={"a/b": ""}),
    bad("no options file named", "-options_file", "-options_file"),
    option_file("an options file of words", "-modes 3\nmodes 4\n", "a.opts:2", "'modes'"),
    option_file("an options file of bytes", bytes(range(1, 256)), "a.opts"),
    option_file("an unknown option in a file", "-modees 3\n", "-modees", "-modes?"),
    option_file("a wrong kind in a file", "# ours\n-modes_block many\n", "-modes_block many"),
    option_file("two words behind an option in a file", "-modes_block 3 4\n", "a.opts:1", "'4'"),
    option_file("a name with a blank in a file without quotes", "-fix left end\n", "a.opts:1", "'end'", "quotes"),
    option_file("a quote in a file that is not closed", "-fix \"left end\n", "a.opts:1", "not closed"),
    option_file("two options on a line", "-quiet -surface_only\n", "a.opts:1", "'-surface_only'"),
    option_file("YAML that is not YAML", "modes: [3\n", "a.yaml", file="a.yaml"),
    option_file("YAML of words", "three modes\n", "a.yaml", file="a.yaml"),
    option_file("an unknown option in YAML", "modees: 3\n", "-modees", "-modes?", file="a.yml"),
    option_file("an unknown nested option in YAML", "material:\n  yuong: 3\n", "-material_yuong", file="a.yml"),
    option_file("a wrong kind in YAML", "modes_block: many\n", "-modes_block many", file="a.yml"),
    option_file("YAML of deep nesting", "a: " + "{a: " * 100000, "a.yaml:1", file="a.yaml"),
    option_file("YAML with an alias", "modes: &m 3\nderivatives: *m\n", "a.yaml:2", "alias", file="a.yaml"),
    option_file("a zero byte in an options file", b"-modes 3\0\n", "a.opts", "zero byte"),
    option_file("an option of a long name", "-" + "x" * 100000 + " 3\n", "-xxx"),
    option_file("a report through a shell", "-modes_eps_view ':x;touch marker;.gz'\n", "-modes_eps_view", "plain name"),
    option_file("a report in a format that is not there", "-log_view :x:ascii_xlm\n", "-log_view", "'ascii_xml'"),
    option_file("YAML with tabs", "material:\n\tyoung: 3\n", "a.yml", file="a.yml"),
    option_file("an options file that names itself", "-options_file a.opts\n", "a.opts:1", "another"),
]

NUMERICS = [
    bad("a stiffness beyond squares", "-material_young 1e200", "double precision", "-units", code=1),
    bad("a stiffness beneath them", "-material_young 1e-300", "double precision", code=1),
    bad("a mass beneath them, iteratively", "-material_density 1e-200 -solver iterative", "double precision", code=1),
    bad("fewer modes converge", "-modes_eps_max_it 1 -modes_eps_ncv 12 -modes_eps_tol 1e-15", "converge", code=1,
        files={"model.h5": "earlier", "frequencies.csv": "earlier"}),
]

WORKING = [
    Case("CRLF in an options file", ["-options_file", "a.opts"], [],
         {"a.opts": "\r\n".join(["# ours"] + [" ".join(pair) for pair in zip(WHOLE[::2], WHOLE[1::2])]) + "\r\n"},
         code=0, leaves=OUTPUTS),
    Case("names with blanks in an options file", ["-options_file", "a.opts", *MATERIAL[2:], "-mesh", "a mesh.msh"], [],
         {"a.opts": '-fix "the bottom"\n-material_big_block_young 1e6\n-modes 2\n',
          "a mesh.msh": MSH2.replace("bottom", "the bottom").replace("block", "big block")}, code=0, leaves=OUTPUTS),
    bad("an option of ritz-full", "-scene scene.toml", code=0, leaves=OUTPUTS),
    bad("options in capitals", "-MODES 3", code=0, leaves=OUTPUTS),
]

CASES = [*UNKNOWN, *SOLVERS, *WORDS, *KINDS, *BOXES, *SUPPORTS, *MATERIALS, *OUTPUT, *OPTION_FILES, *NUMERICS, *WORKING]
