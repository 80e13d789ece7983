// The sections of a .msh file that differ between the versions.
#pragma once
#include <map>

#include "ritz/mesh/read_msh_types.hpp"

namespace ritz::mesh {

/// A .msh file as far as it has been read.
struct MshFile {
  MshInput input;
  ListedMesh mesh;
  Groups groups;
  std::map<Groups::Key, std::vector<Index>> entities;  ///< 4.1: (dimension, entity) -> physical tags
  /// 4.1: how many cells of groups may follow. An entity in very many groups would have few bytes and much memory.
  std::size_t memberships_left = 0;
};

/// $Nodes and, with where each vertex lies on the geometry, $ParametricNodes.
void read_msh2_nodes(MshFile& msh);
void read_msh2_parametric_nodes(MshFile& msh);
void read_msh2_elements(MshFile& msh);

void read_msh4_entities(MshFile& msh);
/// A partitioned mesh has entities of its own, with their parents and partitions.
void read_msh4_partitioned_entities(MshFile& msh);
void read_msh4_nodes(MshFile& msh);
void read_msh4_elements(MshFile& msh);

}  // namespace ritz::mesh
