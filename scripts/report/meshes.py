"""Meshes that no option of the programs makes, as files: functions of a folder that return a path."""
import subprocess
from pathlib import Path

FORK = Path(__file__).resolve().parents[2] / "config" / "fork.geo"


def fork(size, around):
    """config/fork.geo by Gmsh, with cells of `size` m and so many around a full circle."""
    def write(folder):
        path = folder / f"fork-{size:g}-{around}.msh"
        if not path.exists():
            folder.mkdir(parents=True, exist_ok=True)
            geometry = folder / "fork.geo"
            geometry.write_text(f'size = {size!r};\nInclude "{FORK}";\nMesh.MeshSizeFromCurvature = {around};\n')
            part = path.with_suffix(".part.msh")
            subprocess.run(["gmsh", "-3", "-v", "1", "-o", part, geometry], check=True, stdout=subprocess.DEVNULL)
            part.rename(path)
        return str(path)
    return write


def block(cells, size=0.1):
    """A cube of cells³ hexahedra: soft, with a hard grain, half as wide, in the middle of each of its eight eighths. Sets:
    bottom, top. An Abaqus file."""
    n, quarter = cells + 1, cells // 4
    vertex = lambda i, j, k: 1 + i + n * (j + n * k)  # noqa: E731
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))

    def inside(i):
        return quarter // 2 <= i % (2 * quarter) < quarter // 2 + quarter

    def write(folder):
        path = folder / f"block-{cells}.inp"
        folder.mkdir(parents=True, exist_ok=True)
        lines = ["*NODE"] + [f"{vertex(i, j, k)},{size * i / cells!r},{size * j / cells!r},{size * k / cells!r}"
                             for k in range(n) for j in range(n) for i in range(n)]
        regions = {"SOFT": [], "HARD": []}
        for k in range(cells):
            for j in range(cells):
                for i in range(cells):
                    region = "HARD" if inside(i) and inside(j) and inside(k) else "SOFT"
                    number = 1 + i + cells * (j + cells * k)
                    cell = ",".join(str(vertex(i + a, j + b, k + c)) for a, b, c in corners)
                    regions[region].append(f"{number},{cell}")
        for region, cells_of in regions.items():
            lines += [f"*ELEMENT, TYPE=C3D8, ELSET={region}", *cells_of]
        for name, level in (("bottom", 0), ("top", n - 1)):
            lines += [f"*NSET, NSET={name}", *(f"{vertex(i, j, level)}" for j in range(n) for i in range(n))]
        path.write_text("\n".join(lines) + "\n")
        return str(path)
    return write
