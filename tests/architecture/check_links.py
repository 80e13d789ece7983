"""What the programs and libraries are linked with.

    check_links.py BIN LIB      the folders of programs and of static libraries
"""
import re
import subprocess
import sys
from pathlib import Path

PARALLEL = re.compile(r"libmpi|libpetsc|libslepc|libmetis|libhdf5_openmpi|libopen-rte")
OUTSIDE_SYMBOL = re.compile(r"^(MPI_|ompi_|Petsc|Mat|Vec|KSP|EPS|Slepc|H5|METIS_)")


def libraries(program):
    return re.findall(r"^\s*(\S+)", subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout,
                      re.MULTILINE)


def wanted_symbols(library):
    listed = subprocess.run(["nm", "--undefined-only", "--format=posix", library], capture_output=True, text=True,
                            check=True).stdout
    return [line.split()[0] for line in listed.splitlines() if line and not line.endswith(":")]


def check(binaries, archives):
    programs = [binaries / name for name in ("ritz-run", "ritz-inspect", "ritz-scene")]
    for serial in (*programs, *(archives / "python").glob("*.so")):
        for library in libraries(serial):
            if PARALLEL.search(library):
                yield f"{serial.name} is linked with {library}"
    reduce = libraries(binaries / "ritz-reduce")
    if not any(PARALLEL.search(library) for library in reduce):
        yield "ritz-reduce is linked with no parallel library: this check sees nothing"
    if any(re.search(r"libhdf5(_serial)?\.so", library) for library in reduce) and \
            any("libhdf5_openmpi" in library for library in reduce):
        yield "ritz-reduce is linked with both flavours of HDF5"
    for name in ("base", "fem", "model", "runtime", "readers"):
        for library in archives.glob(f"libritz_{name}.a"):
            for symbol in wanted_symbols(library):
                if OUTSIDE_SYMBOL.match(symbol):
                    yield f"{library.name} wants {symbol}"


if __name__ == "__main__":
    complaints = list(check(Path(sys.argv[1]), Path(sys.argv[2])))
    print("\n".join(complaints) or "the runtime's programs and libraries know no MPI, no PETSc and no second HDF5")
    sys.exit(1 if complaints else 0)
