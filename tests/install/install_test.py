"""Installs ritz from its build, and uses it from another project.

    install_test.py SOURCE BUILD WORK [OPTION ...]      the options are those of the compiler that the build links with
"""
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

PARALLEL = re.compile(r"mpi|petsc|slepc|metis|open-rte", re.IGNORECASE)
SERIAL = {"ritz-run", "ritz-inspect"}
LAYERS = {"base", "files", "fem", "model", "runtime", "scene", "world", "format"}


def run(*words):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"failed: {' '.join(map(str, words))}\n{done.stdout}")
    return done.stdout


def needed(program):
    """The names of all libraries that a program loads, its libraries' libraries too."""
    return set(re.findall(r"^\s*(\S+)", run("ldd", program), re.MULTILINE)) | set(
        re.findall(r"\(NEEDED\).*\[(.*)\]", run("readelf", "-d", program)))


def expect(true, message):
    if not true:
        sys.exit(message)


def commands(build):
    """What builds everything in this folder of Ninja's, whatever the folder is called, with what CMake generated to be
    compiled. Nothing where it is not Ninja that builds here."""
    listed = subprocess.run(["ninja", "-C", build, "-t", "commands", "all"], capture_output=True, text=True)
    if listed.returncode != 0:
        return set()
    known = {}

    def content(path):
        if path not in known:
            known[path] = Path(path).read_text().replace(str(build), "BUILD")
        return known[path]

    found = set()
    for command in listed.stdout.splitlines():
        generated = re.findall(rf"{re.escape(str(build))}\S+\.(?:cxx|hxx)(?=\s|$)", command)
        found.add((command.replace(str(build), "BUILD"), *map(content, generated)))
    return found


def check_serial_configuration(source, whole, work):
    """Without its precomputation ritz asks for no MPI and no PETSc, and builds: by commands that the whole build has run,
    or else they are run here."""
    build = work / "serial"
    cache = (whole / "CMakeCache.txt").read_text()
    alike = re.findall(r"^((?:CMAKE_BUILD_TYPE|CMAKE_UNITY_BUILD|CMAKE_CXX_FLAGS\w*|CMAKE_CXX_COMPILER|RITZ_WERROR|RITZ_SANITIZE\w*)"
                       r":\w+=.*)$", cache, re.MULTILINE)
    run("cmake", "-G", "Ninja", "-S", source, "-B", build, "-DRITZ_PRECOMPUTE=OFF", "-DRITZ_TESTS=OFF",
        *("-D" + setting for setting in alike))
    serial = (build / "CMakeCache.txt").read_text()
    expect(not re.search(r"^(PETSC|SLEPC|MPI_C)_FOUND", serial, re.MULTILINE), "a build without MPI looked for it")
    asked = commands(build)
    expect(asked, f"{build} is not built by Ninja")
    new = asked - commands(whole)
    if new:
        print(f"{len(new)} commands are not those of the whole build, such as: {min(new)[0]}")
        run("cmake", "--build", build, "--parallel", "2")


def install(build, prefix):
    shutil.rmtree(prefix, ignore_errors=True)
    run("cmake", "--install", build, "--prefix", prefix)


def check_tree(prefix):
    include = prefix / "include" / "ritz"
    expect({path.name for path in include.iterdir()} == LAYERS, f"{include} holds {sorted(include.iterdir())}")
    programs = {path.name for path in (prefix / "bin").iterdir()}
    expect(programs in (SERIAL, SERIAL | {"ritz-reduce", "ritz-full", "ritz-scene"}), f"bin holds {sorted(programs)}")
    for path in prefix.rglob("*.cmake"):
        expect(str(prefix.parent) not in path.read_text(), f"{path} names the folder it was built in")


def check_module(build, prefix, model):
    """The Python module, where it is built, stands in one folder with its type stubs, and reads a model from there."""
    built = {path.name for path in (build / "python").glob("*.so")}
    installed = list(prefix.glob("lib/python3*/dist-packages/*.so"))
    expect({path.name for path in installed} == built, f"{built} was built, and {installed} installed")
    for module in installed:
        expect((module.parent / "ritz.pyi").is_file(), f"{module.parent} has no ritz.pyi")
        read = run("env", f"PYTHONPATH={module.parent}", "/usr/bin/python3", "-c",
                   f"import ritz; print(ritz.__file__, ritz.read({str(model)!r}).r)")
        expect(read.split() == [str(module), "2"], f"the installed module says {read}")
        expect(not any(map(PARALLEL.search, needed(module))), f"{module} needs {sorted(needed(module))}")


def use_from_outside(consumer, work, prefix, model, options):
    build = work / "consumer"
    shutil.rmtree(build, ignore_errors=True)
    run("cmake", "-S", consumer, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DCMAKE_CXX_FLAGS={' '.join(options)}")
    run("cmake", "--build", build)
    played = float(run(build / "play", model))
    expect(abs(played - math.sin(3) / 6) < 1e-13, f"the consumer's motion is {played}, not sin(3)/6")
    expect(abs(float(run(build / "oscillate")) - math.cos(2)) < 1e-15, "the consumer's oscillator is out of tune")
    return build


def snippets(source):
    """What the pages tell CMake to do with ritz, by the page."""
    pages = [source / "README.md", *sorted((source / "docs").glob("*.md"))]
    return [(page, text) for page in pages
            for text in re.findall(r"^```cmake\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL)
            if "find_package(ritz" in text]


def use_as_documented(source, work, prefix, model, options):
    """The pages' very text builds and runs the example that it names."""
    told = snippets(source)
    expect(source / "README.md" in {page for page, _ in told}, "README.md does not say how another project uses ritz")
    for number, (page, text) in enumerate(told):
        folder = work / f"documented_{number}"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(source / "examples", folder)
        (folder / "CMakeLists.txt").write_text(text)
        run("cmake", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={prefix}",
            f"-DCMAKE_CXX_FLAGS={' '.join(options)}")
        run("cmake", "--build", folder / "build")
        lines = run(folder / "build" / "push", model, "10").splitlines()
        expect(len(lines) == 200 and any(float(line.split()[3]) for line in lines), f"{page}: push moves nothing")


def use_without_hdf5(project, work, prefix, options):
    """ritz::world, where neither pkg-config nor CMake finds HDF5; ritz::format is then refused by what it lacks."""
    nothing = work / "no_packages"
    nothing.mkdir(exist_ok=True)
    hidden = ("env", f"PKG_CONFIG_LIBDIR={nothing}", "PKG_CONFIG_PATH=", "cmake", f"-DCMAKE_PREFIX_PATH={prefix}",
              "-DCMAKE_DISABLE_FIND_PACKAGE_HDF5=ON")
    build = work / "eigen_alone"
    shutil.rmtree(build, ignore_errors=True)
    said = run(*hidden, "-S", project, "-B", build, f"-DCMAKE_CXX_FLAGS={' '.join(options)}")
    expect("ritz without ritz::format" in said, said)
    run("cmake", "--build", build)
    swung = float(run(build / "swing"))
    expect(abs(swung - (1 - math.cos(2))) < 1e-13, f"the body swings to {swung}, not to 1 - cos(2)")
    expect(not any("hdf5" in library for library in needed(build / "swing")), "ritz::world brings HDF5")
    refused(work, hidden, "format", "needs serial HDF5")


def check_links(prefix, build):
    for program in (prefix / "bin" / "ritz-run", prefix / "bin" / "ritz-inspect", build / "play", build / "oscillate"):
        libraries = needed(program)
        expect(any("libc.so" in library for library in libraries), f"nothing seen in {program}")
        expect(not any(map(PARALLEL.search, libraries)), f"{program} needs {sorted(libraries)}")
    expect(any("hdf5_serial" in library for library in needed(build / "play")), "the consumer reads without HDF5?")
    expect(not any("hdf5" in library for library in needed(build / "oscillate")), "ritz::runtime brings HDF5")


def refused(work, cmake, component, why):
    """A component that cannot be had is refused with a sentence."""
    folder = work / f"refused_{component}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.22)\nproject(p LANGUAGES CXX)\n"
                                           f"find_package(ritz REQUIRED COMPONENTS {component})\n")
    done = subprocess.run([*cmake, "-S", folder, "-B", folder / "build"], capture_output=True, text=True)
    expect(done.returncode != 0 and why in " ".join(done.stderr.split()), done.stderr)


def main():
    source, build, work = map(Path, sys.argv[1:4])
    work.mkdir(parents=True, exist_ok=True)
    prefix = work / "prefix"
    check_serial_configuration(source, build, work)
    install(build, prefix)
    check_tree(prefix)
    model = work / "model.h5"
    run(Path(os.environ["RITZ_BIN"]) / "write_sample_model", model)
    check_module(build, prefix, model)
    consumer = use_from_outside(source / "tests" / "install" / "consumer", work, prefix, model, sys.argv[4:])
    check_links(prefix, consumer)
    use_as_documented(source, work, prefix, model, sys.argv[4:])
    use_without_hdf5(source / "tests" / "install" / "eigen_alone", work, prefix, sys.argv[4:])
    refused(work, ("cmake", f"-DCMAKE_PREFIX_PATH={prefix}"), "stages", "no component 'stages'")
    run(prefix / "bin" / "ritz-run", "--help")
    print("ritz installs, and another project runs on it")


if __name__ == "__main__":
    main()
