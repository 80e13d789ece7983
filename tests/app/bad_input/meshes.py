"""Two tetrahedra in each format that ritz reads, small enough to be damaged by hand."""
import struct

POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
TETS = [(1, 2, 3, 4), (2, 3, 4, 5)]


def lines(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows)


MSH2 = f"""$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 7 "bottom"
3 1 "block"
$EndPhysicalNames
$Nodes
5
{lines((i + 1, *x) for i, x in enumerate(POINTS))}$EndNodes
$Elements
3
1 2 2 7 1 1 2 3
{lines((i + 2, 4, 2, 1, 1, *t) for i, t in enumerate(TETS))}$EndElements
"""

MSH2_BINARY = (b"$MeshFormat\n2.2 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n$Nodes\n5\n"
               + b"".join(struct.pack("<i3d", i + 1, *x) for i, x in enumerate(POINTS)) + b"\n$EndNodes\n"
               + b"$Elements\n2\n" + struct.pack("<3i", 4, 2, 2)
               + b"".join(struct.pack("<7i", i + 1, 1, 1, *t) for i, t in enumerate(TETS)) + b"\n$EndElements\n")

MSH4 = f"""$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
3 1 "block"
$EndPhysicalNames
$Entities
0 0 0 1
1 0 0 0 1 1 1 1 1 0
$EndEntities
$Nodes
1 5 1 5
3 1 0 5
{lines([n] for n in range(1, 6))}{lines(POINTS)}$EndNodes
$Elements
1 2 1 2
3 1 4 2
{lines((i + 1, *t) for i, t in enumerate(TETS))}$EndElements
"""

VEG = f"""*VERTICES
5 3 0 0
{lines((i + 1, *x) for i, x in enumerate(POINTS))}
*ELEMENTS
TET
2 4 0
{lines((i + 1, *t) for i, t in enumerate(TETS))}
*MATERIAL steel
ENU, 1000, 1e6, 0.3

*REGION
allElements, steel
"""


def commas(rows):
    return "".join(", ".join(map(str, row)) + "\n" for row in rows)


INP = f"""*NODE
{commas((i + 1, *x) for i, x in enumerate(POINTS))}*ELEMENT, TYPE=C3D4, ELSET=BLOCK
{commas((i + 1, *t) for i, t in enumerate(TETS))}*NSET, NSET=FOOT
1, 2, 3
*MATERIAL, NAME=STEEL
*ELASTIC
1e6, 0.3
*DENSITY
1000
*SOLID SECTION, ELSET=BLOCK, MATERIAL=STEEL
*BOUNDARY
FOOT, 1, 3
"""

VTU = f"""<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid><Piece NumberOfPoints="5" NumberOfCells="2">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
{lines(POINTS)}</DataArray></Points>
<Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">
{lines([v - 1 for v in t] for t in TETS)}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4 8</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10 10</DataArray>
</Cells></Piece></UnstructuredGrid></VTKFile>
"""
