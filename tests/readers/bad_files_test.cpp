// What is wrong with a file costs one sentence that names the file, the line and the matter.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "readers/fixture.hpp"
#include "ritz/base/error.hpp"

namespace ritz::readers::testing {
namespace {

struct Bad {
  const char* from;   ///< this text of the good file ...
  const char* to;     ///< ... becomes this
  const char* where;  ///< what must follow the file's name: a line, or "" for the whole file
  const char* what;   ///< part of the message
};

void expect_errors(const std::string& name, const std::string& good, const std::vector<Bad>& table) {
  for (const auto& bad : table) {
    SCOPED_TRACE(std::string(bad.from) + " -> " + bad.to);
    const auto error = error_of(name, with(good, bad.from, bad.to));
    EXPECT_NE(error.find(name + bad.where + ": "), std::string::npos) << error;
    EXPECT_NE(error.find(bad.what), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

TEST(BadMsh, Version22) {
  expect_errors("a.msh", msh22_text(),
                {{"2.2 0 8", "1.0 0 8", ":2", "version"},
                 {"2.2 0 8", "4.0 0 8", ":2", "version"},
                 {"2.2 0 8", "2.2 0 4", ":2", "4 bytes"},
                 {"2.2 0 8", "2.2 7 8", ":2", "binary"},
                 {"$MeshFormat\n", "", ":2", "$MeshFormat first"},
                 {"$EndMeshFormat", "", ":4", "$EndMeshFormat"},
                 {"$EndComments", "", ":4", "has no end"},
                 {"2 7 \"bottom\"", "2 7 bottom", ":9", "quotes"},
                 {"2 7 \"bottom\"", "5 7 \"bottom\"", ":9", "dimension"},
                 {"3\n2 7", "-3\n2 7", ":8", "negative"},
                 {"$Nodes\n5", "$Nodes\n6", ":20", "expected a vertex number"},
                 {"$Nodes\n5", "$Nodes\n4", ":19", "$EndNodes"},
                 {"$Nodes\n5", "$Nodes\n-5", ":14", "negative"},
                 {"$Nodes\n5", "$Nodes\n4000000000", ":14", "cannot be in the rest"},
                 {"$Nodes\n5", "$Nodes\n99999999999999999999", ":14", "too large"},
                 {"$Nodes\n5", "$Nodes\nfive", ":14", "'five'"},
                 {"7 1 0 0", "7 1 nan 0", ":16", "finite"},
                 {"7 1 0 0", "7 1 inf 0", ":16", "finite"},
                 {"7 1 0 0", "7 1 1e999 0", ":16", "finite"},
                 {"7 1 0 0", "7 1 0", ":16", "end of the line"},
                 {"7 1 0 0", "7 1 0 0 0", ":16", "end of the line"},
                 {"7 1 0 0", "7 1 0x 0", ":16", "'0x'"},
                 {"7 1 0 0", "10 1 0 0", ":16", "vertex 10 is listed twice"},
                 {"7 1 0 0", "8 1 0 0", ":24", "vertex 7"},
                 {"$Elements\n4", "$Elements\n5", ":27", "element number"},
                 {"$Elements\n4", "$Elements\n3", ":26", "$EndElements"},
                 {"$Elements\n4", "$Elements\n-1", ":22", "negative"},
                 {"$Elements\n4", "$Elements\n100000000000", ":22", "cannot be in the rest"},
                 {"5 4 2 1 1 10 7 30 4000", "5 4 2 1 1 10 7 30", ":25", "end of the line"},
                 {"5 4 2 1 1 10 7 30 4000", "5 4 2 1 1 10 7 30 30", ":25", "vertex 30 twice"},
                 {"5 4 2 1 1 10 7 30 4000", "5 4 2 1 1 10 7 30 31", ":25", "vertex 31"},
                 {"5 4 2 1 1 10", "5 4 -2 1 1 10", ":25", "negative"},
                 {"5 4 2 1 1 10", "5 4 2 -9223372036854775808 1 10", ":25", "too large"},
                 {"5 4 2 1 1 10", "5 13 2 1 1 10", ":25", "prism with 18"},
                 {"5 4 2 1 1 10", "5 14 2 1 1 10", ":25", "pyramid with 14"},
                 {"5 4 2 1 1 10", "5 12 2 1 1 10", ":25", "hexahedron with 27"},
                 {"5 4 2 1 1 10", "5 29 2 1 1 10", ":25", "tetrahedron with 20"},
                 {"5 4 2 1 1 10", "5 999 2 1 1 10", ":25", "999"},
                 {"6 4 3 2", "5 4 3 2", ":26", "cell 5 is listed twice"},
                 {"$EndElements", "$EndNodes", ":27", "$EndElements"},
                 {"$Elements\n4", "$Else\n4", ":21", "$Else is not a section that ritz knows; '-ignore ELSE'"}});
}

TEST(BadMsh, Version41) {
  expect_errors("a.msh", msh41_text(),
                {{"1 1 1 2\n", "1 1 1 -2\n", ":11", "negative"},
                 {"1 1 1 2\n", "1 1 1 3\n", ":17", "number of an entity"},
                 {"1 1 1 2\n", "1 1 1 99999\n", ":11", "cannot be in the rest"},
                 {"3 5 7 4000", "3 6 7 4000", ":19", "blocks list 5"},
                 {"3 5 7 4000", "3000000 5 7 4000", ":19", "cannot be in the rest"},
                 {"1 1 1 2\n7\n", "1 1 1 2000000000\n7\n", ":23", "cannot be in the rest"},
                 {"1 1 1 2\n7\n", "8 1 1 2\n7\n", ":23", "dimension"},
                 {"0 0 1\n1 1 1\n", "0 0 1\n", ":32", "coordinate"},
                 {"4 4 1 6", "4 5 1 6", ":35", "blocks list 4"},
                 {"3 1 4 1\n", "2 1 4 1\n", ":40", "dimension"},
                 {"3 1 4 1\n", "3 1 12 1\n", ":40", "27 vertices"},
                 {"3 1 4 1\n", "3 1 4 -1\n", ":40", "negative"},
                 {"6 7 30 4000 50", "6 7 30 4000 51", ":43", "vertex 51"},
                 {"6 7 30 4000 50", "5 7 30 4000 50", ":43", "cell 5 is listed twice"},
                 {"$EndPeriodic", "", ":45", "has no end"}});
}

TEST(BadMsh, Binary) {
  EXPECT_NE(error_of("a.msh", with(msh41_binary(), std::string("8\n\1\0\0\0", 6), std::string("8\n\0\0\0\1", 6)))
                .find("byte order"),
            std::string::npos);
  const auto huge = Bytes().text("$Elements\n").add(std::int64_t{1} << 60).str();
  const auto error =
      error_of("a.msh", with(msh41_binary(), Bytes().text("$Elements\n").add(std::int64_t{3}).str(), huge));
  EXPECT_NE(error.find("a.msh, byte "), std::string::npos) << error;
  EXPECT_NE(error.find("cannot be in the rest"), std::string::npos) << error;
  const auto nan = Bytes().add(std::nan("")).str();
  const auto point = Bytes().add(0.).add(0.).add(1.).str();
  EXPECT_NE(error_of("a.msh", with(msh22_binary(), point, nan + point.substr(8))).find("finite"), std::string::npos);
}

TEST(BadVeg, Files) {
  expect_errors("a.veg", veg_text(),
                {{"5 3 0 0", "-5 3 0 0", ":3", "negative"},
                 {"5 3 0 0", "6 3 0 0", ":10", "vertex 6 of 6"},
                 {"5 3 0 0", "4 3 0 0", ":9", "more entries"},
                 {"5 3 0 0", "5 2 0 0", ":3", "3 numbers"},
                 {"5 3 0 0", "1000000000000 3 0 0", ":10", "vertex 6"},
                 {"3 0 1 0", "4 0 1 0", ":7", "expected number 3"},
                 {"3 0 1 0", "3 0 1", ":7", "coordinate"},
                 {"3 0 1 0", "3 0 NaN 1", ":7", "finite"},
                 {"1 0 0 0", "2 0 0 0", ":4", "expected number 1"},
                 {"TET", "PRISM", ":11", "PRISM"},
                 {"2 4 0", "2 8 0", ":12", "4 numbers"},
                 {"2 4 0", "3 4 0", ":15", "element 3 of 3"},
                 {"2 2 3 4 5", "2 2 3 4 6", ":14", "vertex 6"},
                 {"2 2 3 4 5", "2 2 3 4 4", ":14", "twice"},
                 {"2 2 3 4 5", "2 2 3 4", ":14", "vertex number"},
                 {"ENU, 7800", "MOONEYRIVLIN, x", ":16", "'x'"},
                 {"ENU, 7800", "ORTHOTROPIC, -7800", ":16", "density"},
                 {"ENU, 7800, 2e11, 0.3", "ENU", ":16", "a law, a comma"},
                 {"0.3", "0.5", ":16", "Poisson"},
                 {"2e11", "-2e11", ":16", "Young"},
                 {"7800", "0", ":16", "density"},
                 {"*SET lower\n1", "*SET lower\n3", ":20", "element 3"},
                 {"*SET lower\n1", "*SET upper\n1", ":21", "twice"},
                 {"lower, steel", "lower, wood", ":24", "'wood'"},
                 {"lower, steel", "nowhere, steel", ":24", "'nowhere'"},
                 {"lower, steel", "lower", ":24", "comma"},
                 {"*REGION", "*REGAIN", ":23", "'-ignore REGAIN' leaves it out"},
                 {"*VERTICES", "*INCLUDE absent.veg\n*VERTICES", ":2", "absent.veg"},
                 {"*VERTICES", "*INCLUDE a.veg\n*VERTICES", ":2", "includes itself"}});
}

TEST(BadInp, Files) {
  expect_errors("a.inp", inp_text(),
                {{"*Heading", "*PART, NAME=p", ":1", "*END PART"},
                 {"*Heading", "*INCLUDE, INPUT=a.inp", ":1", "includes itself"},
                 {"*Heading", "*INCLUDE", ":1", "names no file"},
                 {"*Heading", "*SYSTEM", ":1", "SYSTEM"},
                 {"*NODE, NSET=Nall", "*NODE, SYSTEM=C", ":3", "rectangular"},
                 {"7, 1., 0, 0", "7, 1., 0, 0, 0, 0, 1, 2", ":5", "end of the line"},
                 {"7, 1., 0, 0", "7, 1., nan, 0", ":5", "finite"},
                 {"7, 1., 0, 0", "10, 1., 0, 0", ":5", "vertex 10 is listed twice"},
                 {"7, 1., 0, 0", "x, 1., 0, 0", ":5", "'x'"},
                 {"type=CPS3", "type=CPS9", ":10", "CPS9"},
                 {"TYPE=c3d4", "TYPE=C3D20R", ":12", "C3D20R"},
                 {"TYPE=c3d4", "KIND=c3d4", ":12", "needs TYPE="},
                 {"5, 10, 7, 30, 4000", "5, 10, 7, 30", ":14", "too few"},
                 {"5, 10, 7, 30, 4000", "5, 10, 7, 30, 4000, 50", ":14", "end of the line"},
                 {"5, 10, 7, 30, 4000", "5, 10, 7, 30, 99", ":14", "vertex 99"},
                 {"5, 10, 7, 30, 4000", "5, 10, 7, 7, 4000", ":14", "twice"},
                 {"5, 10, 7, 30, 4000", "2, 10, 7, 30, 4000", ":14", "cell 2 is listed twice"},
                 {"\n5, 6\n", "\n6, 5\n", ":19", "GENERATE"},
                 {"\n5, 6\n", "\n5, 6, 0\n", ":19", "GENERATE"},
                 {"*NSET, NSET=feet\n10, 7", "*NSET, NSET=feet\n10, hands", ":21", "'hands'"},
                 {"*NSET, NSET=feet", "*NSET", ":20", "needs NSET="},
                 {"*NSET, NSET=feet", "*NSET, NSET=feet, INSTANCE=i", ":20", "'i'"},
                 {"2e11, 0.3", "2e11, 0.7", ":25", "Poisson"},
                 {"7800.,", "-7800.,", ":27", "density"},
                 {"*MATERIAL, NAME=Steel\n", "", ":23", "before any *MATERIAL"},
                 {"*MATERIAL, NAME=rubber", "*MATERIAL, NAME=STEEL", ":28", "twice"},
                 {"MATERIAL=STEEL", "MATERIAL=wood", ":33", "WOOD"},
                 {"ELSET=upper, MAT", "ELSET=both, MAT", ":35", "overlaps that of Lower in element 5"},
                 {"ELSET=LOWER, MAT", "ELSET=nowhere, MAT", ":33", "'nowhere'"},
                 {"Feet, 1, 2", "Feet, 1, 2, 0.1", ":38", "other than zero"},
                 {"Feet, 1, 2", "Feet, 2, 1", ":38", "before the first"},
                 {"Feet, 1, 2", "Feet, 32", ":38", "freedom 32"},
                 {"Feet, 1, 2", "Hands, 1, 2", ":38", "'Hands'"},
                 {"Feet, 1, 2", "Feet", ":38", "expected"},
                 {"*STEP", "*SURFACE, NAME=s\nlower, S5", ":37", "'S5'"},
                 {"*STEP", "*SURFACE, NAME=s\nlower", ":37", "label"}});
}

TEST(BadVtu, Files) {
  expect_errors(
      "a.vtu", vtu_text(),
      {{"UnstructuredGrid\" v", "PolyData\" v", ":2", "PolyData"},
       {"LittleEndian", "MiddleEndian", ":2", "MiddleEndian"},
       {"\"UInt32\"", "\"UInt16\"", ":2", "UInt16"},
       {"header_type", "compressor=\"vtkZstdDataCompressor\" header_type", ":2", "Zstd"},
       {"</Points>", "", ":27", "XML"},
       {"NumberOfPoints=\"5\"", "NumberOfPoints=\"6\"", ":13", "15 numbers instead of 18"},
       {"NumberOfPoints=\"5\"", "NumberOfPoints=\"-5\"", ":4", "NumberOfPoints"},
       {"NumberOfPoints=\"5\"", "NumberOfPoints=\"999999999999999999\"", ":13", "truncated"},
       {"NumberOfCells=\"3\"", "NumberOfCells=\"9000000000000000000\"", ":25", "truncated"},
       {"NumberOfCells=\"3\"", "", ":4", "NumberOfCells"},
       {"NumberOfComponents=\"3\"", "NumberOfComponents=\"2\"", ":13", "3 components"},
       {"0 0 0 1 0 0\n", "0 0 0 1 0 nan\n", ":14", "finite"},
       {"0 0 0 1 0 0\n", "0 0 0 1 0 a\n", ":14", "'a'"},
       {"0 1 2 3\n", "0 1 2 9\n", ":19", "vertex 9"},
       {"0 1 2 3\n", "0 1 2 -1\n", ":19", "vertex -1"},
       {"0 1 2 3\n", "0 1 2 2\n", ":19", "twice"},
       {"3 7 11", "3 6 11", ":24", "cell 1"},
       {"3 7 11", "3 7 12", ":19", "instead of 12"},
       {"3 7 11", "3 7 -11", ":24", "negative"},
       {"3 7 11", "3 900 11", ":24", "cell 1"},
       {"5 10 10", "5 10 42", ":25", "type 42"},
       {"5 10 10", "5 10 29", ":25", "type 29"},
       {"5 10 10", "5 10 73", ":25", "a Lagrange cell (VTK type 73) with 4 vertices"},
       {"5 10 10", "5 10 72", ":25", "a Lagrange cell (VTK type 72) with 4 vertices"},
       {"5 10 10", "5 10 11", ":24", "cell 2"},
       {"5 10 10", "5 5 5", ":24", "cell 1"},
       {"\"offsets\"", "\"offset\"", ":18", "offsets"},
       {"type=\"Int64\" Name=\"conn", "type=\"Float64\" Name=\"conn", ":19", "integer"},
       {"Name=\"types\" format=\"ascii\"", "Name=\"types\" format=\"appended\" offset=\"0\"", ":25", "AppendedData"},
       {"Name=\"types\" format=\"ascii\"", "Name=\"types\" format=\"binary\"", ":25", "cut off"}});
}

TEST(BadVtu, BinaryData) {
  for (const auto packing : {VtuPacking::plain, VtuPacking::zlib, VtuPacking::lz4, VtuPacking::lzma}) {
    const auto good = vtu_binary(VtuForm::appended_base64, packing, 4);
    EXPECT_NE(error_of("a.vtu", with(good, "NumberOfPoints=\"5\"", "NumberOfPoints=\"6\"")).find("a.vtu:"),
              std::string::npos);
    EXPECT_NE(error_of("a.vtu", with(good, "offset=\"0\"", "offset=\"99999\"")).find("beyond"), std::string::npos);
    EXPECT_NE(error_of("a.vtu", with(good, " _", " ")).find("a.vtu:"), std::string::npos);
  }
  for (const auto packing : {VtuPacking::zlib, VtuPacking::lz4, VtuPacking::lzma}) {
    const auto good = vtu_binary(VtuForm::appended_raw, packing, 4);
    auto damaged = good;
    damaged[good.find(" _") + 2 + 16 + 8] ^= 0x55;  // in the first block, behind its header
    EXPECT_NE(error_of("a.vtu", damaged).find("a.vtu:"), std::string::npos);
  }
  const auto huge = with(vtu_binary(VtuForm::appended_raw, VtuPacking::plain, 8), std::string(" _\5\0\0\0\0\0\0\0", 10),
                         std::string(" _\5\0\0\0\0\0\0\x7f", 10));
  EXPECT_NE(error_of("a.vtu", huge).find("cut off"), std::string::npos);
}

TEST(BadFile, WithoutSolids) {
  EXPECT_NE(error_of("a.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n").find("no vertices"), std::string::npos);
  EXPECT_NE(error_of("a.inp", "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n*ELEMENT, TYPE=S3\n1,1,2,3\n").find("no solid cells"),
            std::string::npos);
  EXPECT_NE(error_of("a.inp", "what is this").find("a.inp: "), std::string::npos);
  EXPECT_NE(error_of("a.veg", "what is this").find("a.veg:1: "), std::string::npos);
  EXPECT_NE(error_of("a.vtu", "what is this").find("a.vtu:1: "), std::string::npos);
  EXPECT_NE(error_of("a.msh", "what is this").find("MeshFormat"), std::string::npos);
  for (const char* const name : {"a.msh", "a.veg", "a.inp", "a.vtu"}) {
    EXPECT_NE(error_of(name, "").find("is empty"), std::string::npos);
  }
}

std::string error_of_path(const std::filesystem::path& path) {
  try {
    read_file(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(BadFile, ThatIsNone) {
  EXPECT_NE(error_of_path("/nowhere/a.msh").find("no such file"), std::string::npos);
  EXPECT_NE(error_of("a.obj", "v 0 0 0").find("ending"), std::string::npos);
  EXPECT_NE(error_of("mesh", "v 0 0 0").find("ending"), std::string::npos);
  const auto folder = std::filesystem::temp_directory_path() / "ritz-reader-folder.msh";
  std::filesystem::create_directories(folder);
  EXPECT_NE(error_of_path(folder).find("is a directory"), std::string::npos);
  std::filesystem::remove(folder);
}

TEST(BadBou, Files) {
  const auto error = [](const char* text) {
    const TemporaryFile file("a.bou", text);
    try {
      read_bou(file.path(), 5);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(error("1,2\n6,").find("a.bou:2: vertex 6"), std::string::npos);
  EXPECT_NE(error("0").find("a.bou:1: vertex 0"), std::string::npos);
  EXPECT_NE(error("1,2,x").find("a.bou:1: "), std::string::npos);
  EXPECT_NE(error("1;2").find("a.bou:1: "), std::string::npos);
  EXPECT_NE(error("1 99999999999999999999").find("too large"), std::string::npos);
  EXPECT_NE(error("\n").find("no vertices"), std::string::npos);
}

}  // namespace
}  // namespace ritz::readers::testing
