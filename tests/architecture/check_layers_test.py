"""check_layers.py must find what it is there to find."""
import tempfile
import unittest
from pathlib import Path

import check_layers

CMAKE = """
ritz_layer(base INSTALLED)
ritz_layer(fem INSTALLED USES base LIBRARIES Eigen3::Eigen)
ritz_layer(format INSTALLED USES base LIBRARIES hdf5)  # serial
ritz_layer(format_mpi FOLDER format USES base fem LIBRARIES hdf5)
ritz_layer(algebra USES base)
ritz_layer(app USES base format_mpi algebra)
"""


class Layers(unittest.TestCase):
    def breaches(self, file, text):
        with tempfile.TemporaryDirectory() as name:
            root = Path(name)
            (root / "CMakeLists.txt").write_text(CMAKE)
            (root / "include/ritz/fem").mkdir(parents=True)
            (root / "src/fem").mkdir(parents=True)
            (root / "src/fem/own.hpp").write_text("#pragma once\n")
            path = root / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text + "\n")
            return check_layers.check(root)[0]

    def assert_right(self, file, text):
        self.assertEqual(self.breaches(file, text), [])

    def assert_wrong(self, file, text, said):
        found = self.breaches(file, text)
        self.assertEqual(len(found), 1, found)
        self.assertIn(said, found[0])

    def test_allowed(self):
        self.assert_right("src/fem/a.cpp", '#include "ritz/base/error.hpp"')
        self.assert_right("src/fem/a.cpp", '#include "own.hpp"')
        self.assert_right("src/fem/a.cpp", "#include <Eigen/Core>\n#include <vector>")
        self.assert_right("src/app/a.cpp", '#include "ritz/format/x.hpp"\n#include <iostream>')
        self.assert_right("src/format/a.cpp", '#include "ritz/fem/x.hpp"\n#include <hdf5.h>')
        self.assert_right("src/algebra/a.cpp", "#include <petscmat.h>\n#include <mpi.h>")

    def test_layers_above(self):
        self.assert_wrong("src/fem/a.cpp", '#include "ritz/algebra/x.hpp"', "fem may not use algebra")
        self.assert_wrong("include/ritz/fem/a.hpp", '#include "ritz/app/x.hpp"', "fem may not use app")

    def test_transitive_is_not_enough(self):
        self.assert_wrong("src/app/a.cpp", '#include "ritz/fem/x.hpp"', "app may not use fem")

    def test_outside_headers(self):
        for header in ("petscmat.h", "slepceps.h", "mpi.h", "hdf5.h", "CLI/CLI.hpp", "toml++/toml.h", "metis.h",
                       "pybind11/numpy.h"):
            self.assert_wrong("src/fem/a.cpp", f"#include <{header}>", "fem may not include")
        self.assert_wrong("src/fem/a.cpp", "#  include <boost/any.hpp>", "no layer may include")
        self.assert_wrong("src/app/a.cpp", "#include <petscsys.h>", "app may not include")

    def test_printing(self):
        self.assert_wrong("src/fem/a.cpp", "#include <iostream>", "may not print")

    def test_paths(self):
        self.assert_wrong("src/fem/a.cpp", '#include "../base/error.hpp"', "climbs out")
        self.assert_wrong("src/fem/a.cpp", '#include "absent.hpp"', "not a header of this folder")

    def test_unknown_folder(self):
        self.assert_wrong("src/helpers/a.cpp", "", "no layer of CMakeLists.txt")


if __name__ == "__main__":
    unittest.main()
