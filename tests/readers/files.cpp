// The two tetrahedra as files. Gmsh's and Abaqus's numbers are sparse and out of order.
#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <tuple>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {

const std::vector<std::array<double, 3>> two_tets_points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
const std::vector<Index> two_tets_cells = {0, 1, 2, 3, 1, 2, 3, 4};

namespace {

constexpr int ids[] = {10, 7, 30, 4000, 50};

std::string base64(const std::string& bytes) {
  constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    }
    for (std::size_t j = 0; j < 4; ++j) result += i + j > bytes.size() ? '=' : alphabet[bits >> (18 - 6 * j) & 63];
  }
  return result;
}

std::string header(const std::vector<std::uint64_t>& numbers, int size, VtuFirst first) {
  std::string bytes;
  for (const auto number : numbers) {
    for (int i = 0; i < size; ++i) {
      const int byte = first == VtuFirst::low_byte ? i : size - 1 - i;
      bytes += static_cast<char>(number >> (8 * byte) & 0xff);
    }
  }
  return bytes;
}

std::string packed(const std::string& part, VtuPacking packing) {
  std::string bytes(2 * part.size() + 256, '\0');
  const auto* const from = reinterpret_cast<const unsigned char*>(part.data());
  auto* const to = reinterpret_cast<unsigned char*>(bytes.data());
  std::size_t length = 0;
  if (packing == VtuPacking::zlib) {
    uLongf room = bytes.size();
    compress(to, &room, from, part.size());
    length = room;
  } else if (packing == VtuPacking::lz4) {
    length = static_cast<std::size_t>(
        LZ4_compress_default(part.data(), bytes.data(), static_cast<int>(part.size()), static_cast<int>(bytes.size())));
  } else {
    lzma_easy_buffer_encode(6, LZMA_CHECK_CRC32, nullptr, from, part.size(), to, &length, bytes.size());
  }
  return bytes.substr(0, length);
}

/// Header and data of one array, as VTK writes them; in blocks of 64 bytes when packed.
struct Block {
  std::string head;
  std::string data;
};

Block block_of(const std::string& bytes, VtuPacking packing, int header_size, VtuFirst first) {
  if (packing == VtuPacking::plain) return {.head = header({bytes.size()}, header_size, first), .data = bytes};
  constexpr std::size_t size = 64;
  std::vector<std::uint64_t> numbers = {(bytes.size() + size - 1) / size, size, bytes.size() % size};
  std::string data;
  for (std::size_t i = 0; i < bytes.size(); i += size) {
    const auto part = packed(bytes.substr(i, size), packing);
    data += part;
    numbers.push_back(part.size());
  }
  return {.head = header(numbers, header_size, first), .data = data};
}

template <class T>
std::string numbers(std::initializer_list<T> values) {
  Bytes bytes;
  for (const T value : values) bytes.add(value);
  return bytes.str();
}

struct VtuArray {
  std::string attributes;
  std::string bytes;
  std::size_t size;  ///< of a number
};

std::string turned(std::string bytes, std::size_t size) {
  for (auto at = bytes.begin(); at != bytes.end(); at += static_cast<std::ptrdiff_t>(size))
    std::reverse(at, at + static_cast<std::ptrdiff_t>(size));
  return bytes;
}

std::string compressor(VtuPacking packing) {
  switch (packing) {
    case VtuPacking::plain: return "";
    case VtuPacking::zlib: return " compressor=\"vtkZLibDataCompressor\"";
    case VtuPacking::lz4: return " compressor=\"vtkLZ4DataCompressor\"";
    case VtuPacking::lzma: break;
  }
  return " compressor=\"vtkLZMADataCompressor\"";
}

}  // namespace

std::string msh22_text() {
  return R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Comments
anything, even $Nodes
$EndComments
$PhysicalNames
3
2 7 "bottom"
3 1 "lower"
3 2 "the upper one"
$EndPhysicalNames
$Nodes
5
10 0 0 0
7 1 0 0
30 0 1.0 0
4000 0 0 1e0
50 +1 1 1
$EndNodes
$Elements
4
1 15 2 0 1 10
2 2 2 7 1 10 30 7
5 4 2 1 1 10 7 30 4000
6 4 3 2 2 0 7 30 4000 50
$EndElements
)";
}

std::string msh22_binary() {
  Bytes b;
  b.text("$MeshFormat\n2.2 1 8\n").add(1).text("\n$EndMeshFormat\n$PhysicalNames\n3\n");
  b.text("2 7 \"bottom\"\n3 1 \"lower\"\n3 2 \"the upper one\"\n$EndPhysicalNames\n$Nodes\n5\n");
  for (std::size_t v = 0; v < 5; ++v) {
    b.add(ids[v]);
    for (const double x : two_tets_points[v]) b.add(x);
  }
  b.text("\n$EndNodes\n$Elements\n3\n").add(2).add(1).add(2).add(2).add(7).add(1).add(10).add(30).add(7);
  b.add(4).add(2).add(2);
  b.add(5).add(1).add(1).add(10).add(7).add(30).add(4000);
  b.add(6).add(2).add(2).add(7).add(30).add(4000).add(50);
  return b.text("\n$EndElements\n").str();
}

std::string msh41_text() {
  return R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
2 7 "bottom"
3 1 "lower"
3 2 "the upper one"
$EndPhysicalNames
$Entities
1 1 1 2
1 0 0 0 0 
1 0 0 0 1 0 0 0 2 1 -1 
1 0 0 0 1 1 0 1 7 1 -1 
1 0 0 0 1 1 1 1 1 1 1 
2 0 0 0 1 1 1 2 2 9 0 
$EndEntities
$Nodes
3 5 7 4000
0 1 0 1
10
0 0 0
1 1 1 2
7
30
1 0 0 0.5
0 1.0 0 0.75
3 2 0 2
4000
50
0 0 1
1 1 1
$EndNodes
$Elements
4 4 1 6
0 1 15 1
1 10
2 1 2 1
2 10 30 7
3 1 4 1
5 10 7 30 4000
3 2 4 1
6 7 30 4000 50
$EndElements
$Periodic
0
$EndPeriodic
)";
}

std::string msh41_binary() {
  using size = std::int64_t;
  Bytes b;
  b.text("$MeshFormat\n4.1 1 8\n").add(1).text("\n$EndMeshFormat\n$PhysicalNames\n3\n");
  b.text("2 7 \"bottom\"\n3 1 \"lower\"\n3 2 \"the upper one\"\n$EndPhysicalNames\n$Entities\n");
  b.add(size{1}).add(size{0}).add(size{1}).add(size{2});
  b.add(1).add(0.).add(0.).add(0.).add(size{0});
  const auto entity = [&](int tag, std::initializer_list<int> physical) {
    b.add(tag);
    for (int i = 0; i < 6; ++i) b.add(0.5);
    b.add(static_cast<size>(physical.size()));
    for (const int group : physical) b.add(group);
    b.add(size{1}).add(-1);
  };
  entity(1, {7});
  entity(1, {1});
  entity(2, {2, 9});
  b.text("\n$EndEntities\n$Nodes\n").add(size{2}).add(size{5}).add(size{7}).add(size{4000});
  const auto nodes = [&](int dimension, std::size_t first, std::size_t last) {
    b.add(dimension).add(1).add(dimension == 2 ? 1 : 0).add(static_cast<size>(last - first));
    for (auto v = first; v < last; ++v) b.add(size{ids[v]});
    for (auto v = first; v < last; ++v) {
      for (const double x : two_tets_points[v]) b.add(x);
      if (dimension == 2) b.add(0.25).add(0.75);
    }
  };
  nodes(2, 0, 3);
  nodes(3, 3, 5);
  b.text("\n$EndNodes\n$Elements\n").add(size{3}).add(size{3}).add(size{2}).add(size{6});
  b.add(2).add(1).add(2).add(size{1}).add(size{2}).add(size{10}).add(size{30}).add(size{7});
  b.add(3).add(1).add(4).add(size{1});
  b.add(size{5}).add(size{10}).add(size{7}).add(size{30}).add(size{4000});
  b.add(3).add(2).add(4).add(size{1});
  b.add(size{6}).add(size{7}).add(size{30}).add(size{4000}).add(size{50});
  return b.text("\n$EndElements\n").str();
}

std::string veg_text() {
  return R"(# two tetrahedra
*VERTICES
5 3 0 0
1 0 0 0
2 1 0 0

3 0 1 0
4 0, 0, 1
5 1 1 1
*ELEMENTS
TET
2 4 0
1 1 2 3 4
2 2 3 4 5
*MATERIAL steel
ENU, 7800, 2e11, 0.3
*MATERIAL rubber
ENU, 950, 1e6, 0.49
*SET lower
1
*SET upper
2,
*REGION
lower, steel
*REGION
upper, rubber
)";
}

std::string inp_text() {
  return R"(*Heading
 two tetrahedra, *not a keyword
*NODE, NSET=Nall
10, 0, 0, 0
7, 1., 0, 0
30, 0, 1.0D+00, 0
4000, 0, 0, 1
50, 1, 1, 1
******* E L E M E N T S *************
*ELEMENT, type=CPS3, ELSET=Bottom
2, 10, 30, 7
*Element, TYPE=c3d4,
 elset=Lower
5, 10, 7, 30, 4000
*ELEMENT, TYPE=C3D4, ELSET=upper
6, 7, 30,
 4000, 50
*ELSET, ELSET=both, GENERATE
5, 6
*NSET, NSET=feet
10, 7,
30,
*MATERIAL, NAME=Steel
*ELASTIC
2e11, 0.3
*DENSITY
7800.,
*MATERIAL, NAME=rubber
*DENSITY
950
*ELASTIC, TYPE=ISO
1e6, 0.49
*SOLID SECTION, ELSET=LOWER, MATERIAL=STEEL
1.,
*SOLID SECTION, ELSET=upper, MATERIAL=Rubber
*STEP
*BOUNDARY
Feet, 1, 2
4000, 3
*END STEP
)";
}

std::string vtu_text() {
  return R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt32">
  <UnstructuredGrid>
    <Piece NumberOfPoints="5" NumberOfCells="3">
      <PointData>
        <DataArray type="UInt8" Name="feet" format="ascii">1 1 1 0 0</DataArray>
        <DataArray type="Float64" Name="heat" format="ascii">1 2 3 4 5</DataArray>
      </PointData>
      <CellData>
        <DataArray type="Int32" Name="region" format="ascii">7 1 2</DataArray>
      </CellData>
      <Points>
        <DataArray type="Float64" Name="Points" NumberOfComponents="3" format="ascii">
          0 0 0 1 0 0
          0 1 0 0 0 1 1 1 1
        </DataArray>
      </Points>
      <Cells>
        <DataArray type="Int64" Name="connectivity" format="ascii">
          0 2 1
          0 1 2 3
          1 2 3 4
        </DataArray>
        <DataArray type="Int64" Name="offsets" format="ascii">3 7 11</DataArray>
        <DataArray type="UInt8" Name="types" format="ascii">5 10 10</DataArray>
      </Cells>
    </Piece>
  </UnstructuredGrid>
</VTKFile>
)";
}

std::string vtu_binary(VtuForm form, VtuPacking packing, int header_size, VtuFirst first) {
  const VtuArray points{R"(type="Float32" Name="Points" NumberOfComponents="3")",
                        numbers<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}), 4};
  const VtuArray feet{R"(type="Int8" Name="feet")", numbers<std::int8_t>({1, 1, 1, 0, 0}), 1};
  const VtuArray region{R"(type="UInt16" Name="gmsh:physical")", numbers<std::uint16_t>({7, 1, 2}), 2};
  const VtuArray vertices{R"(type="UInt64" Name="connectivity")",
                          numbers<std::uint64_t>({0, 2, 1, 0, 1, 2, 3, 1, 2, 3, 4}), 8};
  const VtuArray offsets{R"(type="Int32" Name="offsets")", numbers<std::int32_t>({3, 7, 11}), 4};
  const VtuArray types{R"(type="UInt8" Name="types")", numbers<std::uint8_t>({5, 10, 10}), 1};
  std::string appended;
  const auto written = [&](const VtuArray& array) {
    const auto bytes = first == VtuFirst::low_byte ? array.bytes : turned(array.bytes, array.size);
    const auto [head, data] = block_of(bytes, packing, header_size, first);
    const auto coded = packing != VtuPacking::plain ? base64(head) + base64(data) : base64(head + data);
    if (form == VtuForm::inline_base64) {
      return "<DataArray " + array.attributes + " format=\"binary\">\n  " + coded + "\n</DataArray>\n";
    }
    const auto offset = std::to_string(appended.size());
    appended += form == VtuForm::appended_raw ? head + data : coded;
    return "<DataArray " + array.attributes + " format=\"appended\" offset=\"" + offset + "\"/>\n";
  };
  std::string text = "<VTKFile type=\"UnstructuredGrid\" byte_order=\"";
  text += first == VtuFirst::low_byte ? "LittleEndian\" header_type=\"" : "BigEndian\" header_type=\"";
  text += header_size == 8 ? "UInt64\"" : "UInt32\"";
  text += compressor(packing);
  text += ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"5\" NumberOfCells=\"3\">\n";
  for (const auto& [open, array, close] :
       {std::tuple{"<PointData>", feet, "</PointData>"}, std::tuple{"<CellData>", region, "</CellData>"},
        std::tuple{"<Points>", points, "</Points>"}, std::tuple{"<Cells>", vertices, ""}, std::tuple{"", offsets, ""},
        std::tuple{"", types, "</Cells>"}}) {
    text += open;
    text += written(array);
    text += close;
  }
  text += "</Piece>\n</UnstructuredGrid>\n";
  if (form != VtuForm::inline_base64) {
    const auto* const encoding = form == VtuForm::appended_raw ? "raw" : "base64";
    text += "<AppendedData encoding=\"" + std::string(encoding) + "\">\n _" + appended + "\n</AppendedData>\n";
  }
  return text + "</VTKFile>\n";
}

std::vector<NamedFile> good_files() {
  std::vector<NamedFile> files = {{"msh22 text", "a.msh", msh22_text()}, {"msh22 binary", "a.msh", msh22_binary()},
                                  {"msh41 text", "a.msh", msh41_text()}, {"msh41 binary", "a.msh", msh41_binary()},
                                  {"veg", "a.veg", veg_text()},          {"inp", "a.inp", inp_text()},
                                  {"vtu text", "a.vtu", vtu_text()}};
  for (const auto form : {VtuForm::inline_base64, VtuForm::appended_base64, VtuForm::appended_raw}) {
    for (const auto packing : {VtuPacking::plain, VtuPacking::zlib, VtuPacking::lz4, VtuPacking::lzma}) {
      for (const int size : {4, 8}) {
        for (const auto first : {VtuFirst::low_byte, VtuFirst::high_byte}) {
          const auto label = "vtu form " + std::to_string(static_cast<int>(form)) + " packing " +
                             std::to_string(static_cast<int>(packing)) + " header " + std::to_string(size) +
                             " first byte " + std::to_string(static_cast<int>(first));
          files.push_back({label, "a.vtu", vtu_binary(form, packing, size, first)});
        }
      }
    }
  }
  return files;
}

}  // namespace ritz::readers::testing
