#include "ritz/readers/msh_file.hpp"

#include <algorithm>
#include <cstdlib>

namespace ritz::readers {

namespace {

// The count of a section is text in binary files too.
Index open_section(MshInput& input, std::string_view what, Index values) {
  input.cursor.skip_space();
  const Index count = input.cursor.integer("the number of " + std::string(what));
  input.check_count(count, what, values);
  input.open_binary();
  return count;
}

void read_node(MshFile& msh) {
  auto& input = msh.input;
  input.begin_record();
  const auto place = input.place();
  const Index id = input.integer("a vertex number");
  std::array<double, 3> point;
  for (double& x : point) x = input.real("a coordinate");
  add_vertex(msh.mesh, id, point, place);
}

struct ElementHeader {
  Shape shape;
  Index tags;
};

struct Element {
  Shape shape;
  Index id;
  Index physical;
  std::span<const Index> vertices;
};

// A cell in several physical groups is written once for each with a new number, one right after the other.
bool repeats_last(const MshFile& msh, const Element& element) {
  const auto& mesh = msh.mesh;
  if (mesh.shapes.empty() || mesh.shapes.back() != element.shape || mesh.cell_ids.back() == element.id) return false;
  const auto cell = static_cast<Index>(mesh.shapes.size()) - 1;
  const auto group = msh.groups.cells.find({element.shape.dimension, element.physical});
  if (group != msh.groups.cells.end() && group->second.back() == cell) return false;
  const auto last = mesh.vertices_of(cell);
  return std::equal(last.begin(), last.end(), element.vertices.begin(), element.vertices.end());
}

void read_element_body(MshFile& msh, const ElementHeader& header, Index id, Place place) {
  auto& input = msh.input;
  Index physical = 0;
  for (Index i = 0; i < header.tags; ++i) {
    const Index tag = input.integer("an element tag");
    if (i == 0) physical = std::abs(tag);
  }
  std::array<Index, fem::max_cell_vertices> storage;
  const auto kind = header.shape;
  const auto vertices = std::span(storage).first(static_cast<std::size_t>(kind.vertices));
  for (Index& vertex : vertices) vertex = input.integer("a vertex number");
  input.end_record();
  reorder_from_msh(header.shape, vertices);
  const Element element{.shape = header.shape, .id = id, .physical = physical, .vertices = vertices};
  if (!repeats_last(msh, element)) add_cell(msh.mesh, header.shape, id, vertices, place);
  join_physical(msh.groups, msh.mesh, physical);
}

ElementHeader read_header(MshInput& input, Index type) {
  const auto shape = msh_shape(input, type);
  const Index tags = input.integer("the number of tags");
  return {.shape = shape, .tags = tags};
}

void read_text_elements(MshFile& msh, Index count) {
  auto& input = msh.input;
  for (Index i = 0; i < count; ++i) {
    input.begin_record();
    const auto place = input.place();
    const Index id = input.integer("an element number");
    const Index type = input.integer("an element type");
    auto header = read_header(input, type);
    input.check_count(header.tags, "tags", 1);
    read_element_body(msh, header, id, place);
  }
}

// Binary elements come in blocks of one type.
void read_binary_elements(MshFile& msh, Index count) {
  auto& input = msh.input;
  while (count > 0) {
    const Index type = input.integer("an element type");
    const Index block = input.integer("the number of elements of a block");
    const auto header = read_header(input, type);
    input.check_count(header.tags, "tags", 1);
    input.check_count(block, "elements", header.tags + 2);
    if (block < 1 || block > count) input.fail("a block has more elements than the section, or none");
    for (Index i = 0; i < block; ++i) {
      const auto place = input.place();
      const Index id = input.integer("an element number");
      read_element_body(msh, header, id, place);
    }
    count -= block;
  }
}

}  // namespace

void read_msh2_nodes(MshFile& msh) {
  const Index count = open_section(msh.input, "vertices", 4);
  for (Index i = 0; i < count; ++i) {
    read_node(msh);
    msh.input.end_record();
  }
  msh.input.close_section("Nodes");
}

void read_msh2_parametric_nodes(MshFile& msh) {
  auto& input = msh.input;
  const Index count = open_section(input, "vertices", 6);
  for (Index i = 0; i < count; ++i) {
    read_node(msh);
    const Index dimension = input.integer("the dimension of an entity");
    if (dimension < 0 || dimension > 3) input.fail("the dimension of an entity must be 0 to 3");
    input.integer("the number of an entity");
    const Index parameters = dimension == 3 ? 0 : dimension;
    for (Index j = 0; j < parameters; ++j) input.real("a parametric coordinate");
    input.end_record();
  }
  input.close_section("ParametricNodes");
}

void read_msh2_elements(MshFile& msh) {
  const Index count = open_section(msh.input, "elements", 3);
  if (msh.input.encoding == MshEncoding::text) read_text_elements(msh, count);
  else read_binary_elements(msh, count);
  msh.input.close_section("Elements");
}

}  // namespace ritz::readers
