#include "ritz/mesh/part.hpp"

#include <metis.h>

#include "ritz/algebra/graph_partition.hpp"
#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/redistribute.hpp"

namespace ritz::mesh {
namespace {

template <class Int>
struct Graph {
  std::vector<Int> starts, columns;
};

template <class Int>
Graph<Int> make_graph(Index cells, const std::vector<std::array<Index, 2>>& pairs) {
  Graph<Int> graph;
  graph.starts.assign(static_cast<std::size_t>(cells) + 1, 0);
  for (const auto& pair : pairs)
    for (const Index c : pair) ++graph.starts[static_cast<std::size_t>(c) + 1];
  for (std::size_t c = 0; c < static_cast<std::size_t>(cells); ++c) graph.starts[c + 1] += graph.starts[c];
  graph.columns.resize(2 * pairs.size());
  auto next = graph.starts;
  for (const auto& [a, b] : pairs) {
    graph.columns[static_cast<std::size_t>(next[static_cast<std::size_t>(a)]++)] = static_cast<Int>(b);
    graph.columns[static_cast<std::size_t>(next[static_cast<std::size_t>(b)]++)] = static_cast<Int>(a);
  }
  return graph;
}

}  // namespace

std::vector<std::int32_t> partition_metis(Index cells, const std::vector<std::array<Index, 2>>& neighbours, int ranks) {
  std::vector<std::int32_t> parts(static_cast<std::size_t>(cells), 0);
  if (ranks == 1) return parts;
  if (cells <= ranks) {
    for (std::size_t c = 0; c < parts.size(); ++c) parts[c] = static_cast<std::int32_t>(c);
    return parts;
  }
  auto graph = make_graph<idx_t>(cells, neighbours);
  std::vector<idx_t> answer(parts.size());
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  auto n = static_cast<idx_t>(cells), constraints = idx_t{1}, wanted = static_cast<idx_t>(ranks), cut = idx_t{0};
  const int status = METIS_PartGraphKway(&n, &constraints, graph.starts.data(), graph.columns.data(), nullptr, nullptr,
                                         nullptr, &wanted, nullptr, nullptr, options.data(), &cut, answer.data());
  if (status != METIS_OK)
    throw NumericalError("METIS could not partition the mesh (status " + std::to_string(status) + ")");
  for (std::size_t c = 0; c < parts.size(); ++c) parts[c] = static_cast<std::int32_t>(answer[c]);
  return parts;
}

std::vector<std::int32_t> partition_ptscotch(MPI_Comm comm, Index cells,
                                             const std::vector<std::array<Index, 2>>& neighbours) {
  MPI_Bcast(&cells, 1, MPI_INT64_T, 0, comm);
  const auto ranks = static_cast<std::size_t>(parallel::size(comm));
  std::vector<std::vector<std::int64_t>> degrees(ranks), columns(ranks);
  if (parallel::rank(comm) == 0) {
    const auto graph = make_graph<std::int64_t>(cells, neighbours);
    for (Index c = 0; c < cells; ++c) {
      const auto p = static_cast<std::size_t>(parallel::slice_owner(static_cast<int>(ranks), cells, c));
      const auto from = graph.starts[static_cast<std::size_t>(c)], to = graph.starts[static_cast<std::size_t>(c) + 1];
      degrees[p].push_back(to - from);
      columns[p].insert(columns[p].end(), graph.columns.begin() + from, graph.columns.begin() + to);
    }
  }
  const auto my_degrees = parallel::exchange(comm, degrees)[0];
  const auto my_columns = parallel::exchange(comm, columns)[0];
  std::vector<PetscInt> starts = {0};
  for (const auto d : my_degrees) starts.push_back(starts.back() + static_cast<PetscInt>(d));
  const auto parts =
      algebra::partition_graph(comm, starts, {my_columns.begin(), my_columns.end()}, static_cast<PetscInt>(cells));
  return parallel::gather_all(comm, parts);
}

}  // namespace ritz::mesh
