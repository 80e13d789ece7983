#include "ritz/stages/cubature_candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "ritz/base/random.hpp"
#include "ritz/fem/element.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/each_cell.hpp"

namespace ritz::stages {
namespace {

constexpr int classes = 40;  ///< of volume, an octave each; the last has all smaller cells

using Counts = std::array<std::int64_t, classes>;

double volume(const Cell& cell) {
  const fem::IntegrationPoints points(cell.type, cell.x);
  double sum = 0;
  for (int q = 0; q < points.count(); ++q) sum += points.weight(q);
  return sum;
}

struct Candidate {
  int cell;
  std::uint64_t hash;
  double volume;
};

/// This rank's cells that can be chosen.
std::vector<Candidate> eligible(const Problem& problem, model::Integrand integrand) {
  std::vector<Candidate> cells;
  std::vector<bool> polynomial;
  for (const auto& material : problem.materials) polynomial.push_back(fem::force_degree({material}).has_value());
  each_owned_cell(problem.mesh, problem.materials, [&](const Cell& cell) {
    if (integrand == model::Integrand::beyond_polynomial && polynomial[static_cast<std::size_t>(cell.region)]) return;
    const auto number = problem.mesh.cells.numbers[static_cast<std::size_t>(cell.number)];
    cells.push_back({cell.number, split_mix(static_cast<std::uint64_t>(number)), volume(cell)});
  });
  return cells;
}

Counts summed(MPI_Comm comm, Counts counts) {
  MPI_Allreduce(MPI_IN_PLACE, counts.data(), classes, MPI_INT64_T, MPI_SUM, comm);
  return counts;
}

/// How many of each class are taken.
Counts quotas(const Counts& counts, const std::array<double, classes>& volumes, std::int64_t most) {
  double volume = 0, cells = 0;
  for (std::size_t k = 0; k < classes; ++k) {
    volume += volumes[k];
    cells += static_cast<double>(counts[k]);
  }
  // Classes that have fewer cells than their share leave the rest to the others.
  Counts taken{};
  for (std::int64_t left = most; left > 0;) {
    const std::int64_t before = left;
    const auto share = static_cast<double>(left);
    for (std::size_t k = 0; k < classes && left > 0; ++k) {
      double part = (static_cast<double>(counts[k]) / cells + volumes[k] / volume) / 2;
      part = std::max(std::round(part * 0x1p20), 1.0) * 0x1p-20;  // rounding of the volumes shall not matter
      const auto more = std::min({static_cast<std::int64_t>(std::ceil(part * share)), counts[k] - taken[k], left});
      taken[k] += more;
      left -= more;
    }
    if (left == before) break;
  }
  return taken;
}

/// The number of hashes of each class that are at most the bound of the class. The hashes are sorted.
Counts below(const std::array<std::vector<std::uint64_t>, classes>& hashes,
             const std::array<std::uint64_t, classes>& bounds) {
  Counts counts{};
  for (std::size_t k = 0; k < classes; ++k)
    counts[k] = std::ranges::upper_bound(hashes[k], bounds[k]) - hashes[k].begin();
  return counts;
}

/// For each class the least bound that `wanted` hashes of all ranks do not exceed, bit by bit. *Collective*.
std::array<std::uint64_t, classes> bounds_for(MPI_Comm comm,
                                              const std::array<std::vector<std::uint64_t>, classes>& hashes,
                                              const Counts& wanted) {
  std::array<std::uint64_t, classes> low{};
  for (int bit = 63; bit >= 0; --bit) {
    auto middle = low;
    for (auto& bound : middle) bound += (std::uint64_t{1} << bit) - 1;
    const Counts found = summed(comm, below(hashes, middle));
    for (std::size_t k = 0; k < classes; ++k)
      if (found[k] < wanted[k]) low[k] = middle[k] + 1;
  }
  return low;
}

/// The sample of `most`. *Collective*.
std::vector<Candidate> sampled(MPI_Comm comm, std::vector<Candidate> cells, std::int64_t most) {
  double largest = 0;
  for (const auto& cell : cells) largest = std::max(largest, cell.volume);
  const int top = std::ilogb(parallel::max(comm, largest));
  const auto class_of = [&](const Candidate& cell) {
    return static_cast<std::size_t>(std::clamp(top - std::ilogb(cell.volume), 0, classes - 1));
  };
  Counts counts{};
  std::array<double, classes> volumes{};
  std::array<std::vector<std::uint64_t>, classes> hashes;
  for (const auto& cell : cells) {
    counts[class_of(cell)] += 1;
    volumes[class_of(cell)] += cell.volume;
    hashes[class_of(cell)].push_back(cell.hash);
  }
  for (auto& of_class : hashes) std::ranges::sort(of_class);
  counts = summed(comm, counts);
  MPI_Allreduce(MPI_IN_PLACE, volumes.data(), classes, MPI_DOUBLE, MPI_SUM, comm);
  const Counts wanted = quotas(counts, volumes, most);
  const auto bounds = bounds_for(comm, hashes, wanted);
  std::erase_if(cells, [&](const Candidate& cell) {
    const auto k = class_of(cell);
    return wanted[k] == 0 || cell.hash > bounds[k];
  });
  return cells;
}

}  // namespace

std::vector<int> cubature_candidates(const Problem& problem, model::Integrand integrand, std::int64_t most) {
  const mesh::Mesh& mesh = problem.mesh;
  auto candidates = eligible(problem, integrand);
  if (parallel::sum(mesh.comm, static_cast<std::int64_t>(candidates.size())) > most)
    candidates = sampled(mesh.comm, std::move(candidates), most);
  std::vector<int> cells;
  for (const auto& candidate : candidates) cells.push_back(candidate.cell);
  std::ranges::stable_sort(cells, {}, [&](int c) { return mesh.cells.regions[static_cast<std::size_t>(c)]; });
  return cells;
}

}  // namespace ritz::stages
