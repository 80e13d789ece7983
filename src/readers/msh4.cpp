#include "ritz/readers/msh_file.hpp"

namespace ritz::readers {

namespace {

Index read_dimension(MshInput& input) {
  const Index dimension = input.integer("the dimension of an entity");
  if (dimension < 0 || dimension > 3) input.fail("the dimension of an entity must be 0 to 3");
  return dimension;
}

void skip_integers(MshInput& input, std::string_view what) {
  for (Index left = input.count(what, 1); left > 0; --left) input.integer(what);
}

// From the corner coordinates (a point's own, else a bounding box) to the end of the record.
std::vector<Index> read_physical_tags(MshInput& input, int dimension) {
  for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) input.real("a coordinate of an entity");
  std::vector<Index> tags(static_cast<std::size_t>(input.count("physical tags", 1)));
  for (Index& tag : tags) tag = input.integer("a physical tag");
  if (dimension > 0) skip_integers(input, "bounding entities");
  input.end_record();
  return tags;
}

std::array<Index, 4> read_entity_counts(MshInput& input) {
  input.begin_record();
  std::array<Index, 4> counts;
  for (Index& count : counts) count = input.count("entities", 5);
  input.end_record();
  return counts;
}

template <class SkipParents>
void read_entity_list(MshFile& msh, SkipParents skip_parents) {
  auto& input = msh.input;
  const auto counts = read_entity_counts(input);
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (Index i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
      input.begin_record();
      const Index tag = input.integer("the number of an entity");
      skip_parents();
      msh.entities[{dimension, tag}] = read_physical_tags(input, dimension);
    }
  }
}

// The two totals of $Nodes and $Elements; the smallest and largest number that follow them say nothing new.
struct Totals {
  Index blocks;
  Index entries;
  MshInput here;
};

Totals read_totals(MshInput& input, std::string_view what) {
  input.begin_record();
  const auto here = input;
  const Index blocks = input.count("blocks", 4);
  const Index entries = input.count(what, 2);
  input.size("the smallest number");
  input.size("the largest number");
  input.end_record();
  return {.blocks = blocks, .entries = entries, .here = here};
}

void check_total(const Totals& stated, std::string_view what, Index listed) {
  if (stated.entries == listed) return;
  stated.here.fail("the section states " + std::to_string(stated.entries) + " " + std::string(what) +
                   " but its blocks list " + std::to_string(listed));
}

Index read_node_block(MshFile& msh) {
  auto& input = msh.input;
  input.begin_record();
  const Index dimension = read_dimension(input);
  input.integer("the number of an entity");
  const Index parametric = input.integer("whether vertices have parametric coordinates");
  const Index count = input.count("vertices", 4);
  input.end_record();
  std::vector<std::pair<Index, Place>> tags(static_cast<std::size_t>(count));
  for (auto& [tag, place] : tags) {
    input.begin_record();
    place = input.place();
    tag = input.size("a vertex number");
    input.end_record();
  }
  for (const auto& [tag, place] : tags) {
    input.begin_record();
    std::array<double, 3> point;
    for (double& x : point) x = input.real("a coordinate");
    for (Index i = 0; parametric != 0 && i < dimension; ++i) input.real("a parametric coordinate");
    input.end_record();
    add_vertex(msh.mesh, tag, point, place);
  }
  return count;
}

Index read_element_block(MshFile& msh) {
  auto& input = msh.input;
  input.begin_record();
  const auto dimension = static_cast<int>(read_dimension(input));
  const Index entity = input.integer("the number of an entity");
  const auto shape = msh_shape(input, input.integer("an element type"));
  const auto kind = shape;
  if (kind.dimension != dimension) input.fail("this element type is not of its block's dimension");
  const Index count = input.count("elements", 1 + kind.vertices);
  input.end_record();
  std::array<Index, fem::max_cell_vertices> storage;
  const auto vertices = std::span(storage).first(static_cast<std::size_t>(kind.vertices));
  const auto physical = msh.entities.find({dimension, entity});
  for (Index i = 0; i < count; ++i) {
    input.begin_record();
    const auto place = input.place();
    const Index id = input.size("an element number");
    for (Index& vertex : vertices) vertex = input.size("a vertex number");
    input.end_record();
    reorder_from_msh(shape, vertices);
    add_cell(msh.mesh, shape, id, vertices, place);
    if (physical == msh.entities.end()) continue;
    if (physical->second.size() > msh.memberships_left)
      input.fail("the cells are in more physical groups than a file of this size can need");
    msh.memberships_left -= physical->second.size();
    for (const Index tag : physical->second) join_physical(msh.groups, msh.mesh, tag);
  }
  return count;
}

}  // namespace

void read_msh4_entities(MshFile& msh) {
  read_entity_list(msh, [] {});
  msh.input.close_section("Entities");
}

void read_msh4_partitioned_entities(MshFile& msh) {
  auto& input = msh.input;
  input.begin_record();
  input.size("the number of partitions");
  input.end_record();
  input.begin_record();
  for (Index left = 2 * input.count("ghost entities", 2); left > 0; --left) {
    if (left % 2 == 0) input.begin_record();
    input.integer("a ghost entity");
  }
  input.end_record();
  read_entity_list(msh, [&] {
    input.integer("the dimension of a parent");
    input.integer("the number of a parent");
    skip_integers(input, "partitions");
  });
  input.close_section("PartitionedEntities");
}

void read_msh4_nodes(MshFile& msh) {
  const auto stated = read_totals(msh.input, "vertices");
  Index listed = 0;
  for (Index block = 0; block < stated.blocks; ++block) listed += read_node_block(msh);
  check_total(stated, "vertices", listed);
  msh.input.close_section("Nodes");
}

void read_msh4_elements(MshFile& msh) {
  const auto stated = read_totals(msh.input, "elements");
  Index listed = 0;
  for (Index block = 0; block < stated.blocks; ++block) listed += read_element_block(msh);
  check_total(stated, "elements", listed);
  msh.input.close_section("Elements");
}

}  // namespace ritz::readers
