"""A model as ParaView sees it: VTK's own reader finds the grid and the modes as point vectors."""
import os
import sys
import tempfile

import programs
from program import BIN

try:
    from vtkmodules.vtkIOHDF import vtkHDFReader
except ImportError:
    sys.exit(77)

NAMES = ["mode 01, 0.3183 Hz", "mode 02, 0.4775 Hz"]  # sqrt(4) and sqrt(9) rad/s

with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "model.h5")
    programs.run(BIN / "write_sample_model", path)
    reader = vtkHDFReader()
    reader.SetFileName(os.path.join(folder, "model.hdf"))
    reader.Update()
    grid = reader.GetOutput()
    assert grid.GetNumberOfPoints() == 4 and grid.GetNumberOfCells() == 1 and grid.GetCellType(0) == 10
    assert grid.GetPoint(1) == (1, 0, 0)
    vectors = grid.GetPointData()
    assert [vectors.GetArrayName(i) for i in range(vectors.GetNumberOfArrays())] == NAMES
    assert abs(vectors.GetArray(NAMES[0]).GetTuple(0)[2] - 0.1 * 3**0.5) < 1e-7  # a tenth of the box's diagonal
    assert vectors.GetArray(NAMES[1]).GetTuple(0) == (0, 0, 0)

    # Of two bodies each has a file of its own; the one named after the model shows the first.
    programs.run(BIN / "write_sample_model", path, "two-bodies")
    for name, x in ("model", 0), ("model.body", 0), ("model.arm%2Fupper", 5):
        reader = vtkHDFReader()
        reader.SetFileName(os.path.join(folder, name + ".hdf"))
        reader.Update()
        grid = reader.GetOutput()
        assert grid.GetNumberOfPoints() == 4 and grid.GetPoint(0) == (x, 0, 0), name
        assert grid.GetPointData().GetNumberOfArrays() == 2
