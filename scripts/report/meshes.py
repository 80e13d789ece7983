"""Meshes that no option of the programs makes: values that write themselves as a file into a folder."""
from dataclasses import dataclass
from pathlib import Path

import programs

FORK = Path(__file__).resolve().parents[2] / "config" / "fork.geo"
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))


@dataclass(frozen=True)
class Fork:
    """config/fork.geo by Gmsh."""
    size: float  # m, of a cell
    around: int  # cells around a full circle

    def write(self, folder):
        path = folder / f"fork-{self.size:g}-{self.around}.msh"
        if not path.exists():
            folder.mkdir(parents=True, exist_ok=True)
            geometry, part = path.with_suffix(".geo"), path.with_suffix(".part.msh")
            geometry.write_text(f'size = {self.size!r};\nInclude "{FORK}";\n'
                                f"Mesh.MeshSizeFromCurvature = {self.around};\n")
            programs.run("gmsh", "-3", "-v", "1", "-o", part, geometry)
            part.rename(path)
        return str(path)


@dataclass(frozen=True)
class Block:
    """A cube of cells³ hexahedra as an Abaqus file: soft, with a hard grain, half as wide, in the middle of each of its
    eight eighths. Sets: bottom, top."""
    cells: int  # along an edge, a multiple of 4
    size: float = 0.1  # m

    def write(self, folder):
        path = folder / f"block-{self.cells}.inp"
        folder.mkdir(parents=True, exist_ok=True)
        path.write_text("\n".join([*self.vertices(), *self.hexahedra(), *self.ends()]) + "\n")
        return str(path)

    def number(self, i, j, k):
        n = self.cells + 1
        return 1 + i + n * (j + n * k)

    def vertices(self):
        n = range(self.cells + 1)
        at = lambda i: repr(self.size * i / self.cells)  # noqa: E731
        return ["*NODE"] + [f"{self.number(i, j, k)},{at(i)},{at(j)},{at(k)}" for k in n for j in n for i in n]

    def hexahedra(self):
        regions, quarter = {"SOFT": [], "HARD": []}, self.cells // 4
        inside = lambda i: quarter // 2 <= i % (2 * quarter) < quarter // 2 + quarter  # noqa: E731
        n = range(self.cells)
        for number, (k, j, i) in enumerate(((k, j, i) for k in n for j in n for i in n), 1):
            region = "HARD" if inside(i) and inside(j) and inside(k) else "SOFT"
            corners = ",".join(str(self.number(i + a, j + b, k + c)) for a, b, c in CORNERS)
            regions[region].append(f"{number},{corners}")
        return [line for region, cells in regions.items() for line in (f"*ELEMENT, TYPE=C3D8, ELSET={region}", *cells)]

    def ends(self):
        n = range(self.cells + 1)
        return [line for name, level in (("bottom", 0), ("top", self.cells))
                for line in (f"*NSET, NSET={name}", *(str(self.number(i, j, level)) for j in n for i in n))]
