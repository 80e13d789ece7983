"""A deck that CalculiX reads as well: a bar of crooked cells of any type, clamped at one end."""

EDGES = {"C3D20": [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)],
         "C3D15": [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)],
         "C3D10": [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]}
CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
WEDGES = [(0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)]
TETRAHEDRA = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
PARTS = {"C3D6": WEDGES, "C3D15": WEDGES, "C3D4": TETRAHEDRA, "C3D10": TETRAHEDRA}


def crooked(kind, count=(6, 2, 2), size=(.09, .024, .018)):
    """A bar of 6 x 2 x 2 crooked hexahedra of one type of element, or of so many times two wedges or six tetrahedra, of
    steel; its foremost vertex is the set TIP."""
    numbers = {}
    cells = []
    for corner in ((i, j, k) for i in range(count[0]) for j in range(count[1]) for k in range(count[2])):
        cube = [tuple(2 * (c + d) for c, d in zip(corner, at)) for at in CUBE]
        for cell in [[cube[v] for v in part] for part in PARTS.get(kind, [range(8)])]:
            middles = [tuple((a + b) // 2 for a, b in zip(cell[i], cell[j])) for i, j in EDGES.get(kind, [])]
            cells.append([numbers.setdefault(place, len(numbers) + 1) for place in cell + middles])
    points = []
    for place in numbers:
        x, y, z = (length * i / (2 * n) for length, i, n in zip(size, place, count))
        points.append((x * (1 + .2 * y / size[1]), y * (1 + .3 * x / size[0]), z + .1 * x * x / size[0] + .05 * y))
    tip = max(range(len(points)), key=lambda v: points[v][0]) + 1
    text = "*NODE\n" + "".join(f"{n + 1}, {x!r}, {y!r}, {z!r}\n" for n, (x, y, z) in enumerate(points))
    text += f"*ELEMENT, TYPE={kind}, ELSET=BAR\n"
    text += "".join(f"{n + 1},\n" + ",\n".join(map(str, cell)) + "\n" for n, cell in enumerate(cells))
    text += "*NSET, NSET=FIX\n" + ",\n".join(str(n) for place, n in numbers.items() if place[0] == 0)
    text += f"\n*NSET, NSET=TIP\n{tip}\n*MATERIAL, NAME=STEEL\n*ELASTIC\n2.1e11, .3\n*DENSITY\n7850.\n"
    return text + "*SOLID SECTION, ELSET=BAR, MATERIAL=STEEL\n*BOUNDARY\nFIX, 1, 3\n"


def on_top(kind, count=(6, 2, 2)):
    """The number of the face by which cells of crooked(kind) look along z, and those cells on the top of the bar."""
    face, of_cube = {"C3D8": (2, [0]), "C3D20": (2, [0]), "C3D6": (2, [0, 1]), "C3D15": (2, [0, 1])}.get(kind, (3, [3, 4]))
    parts = len(PARTS.get(kind, [()]))
    cubes = range(count[2] - 1, count[0] * count[1] * count[2], count[2])
    return face, [parts * cube + part + 1 for cube in cubes for part in of_cube]
