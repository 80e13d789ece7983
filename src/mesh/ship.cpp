#include "ritz/mesh/part.hpp"

#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {
namespace {

/// Writes integers one after another; lists with their lengths before them.
struct Packer {
  std::vector<std::int64_t> words;

  void operator()(std::int64_t x) { words.push_back(x); }
  void operator()(const std::vector<CellFace>& faces) {
    (*this)(static_cast<std::int64_t>(faces.size()));
    for (const auto& f : faces) words.insert(words.end(), {f.cell, f.face});
  }
  template <class T>
  void operator()(const std::vector<T>& list) {
    (*this)(static_cast<std::int64_t>(list.size()));
    for (const auto& x : list) words.push_back(static_cast<std::int64_t>(x));
  }
};

/// Reads them back in the same order.
struct Unpacker {
  const std::vector<std::int64_t>& words;
  std::size_t at = 0;

  std::int64_t next() { return words[at++]; }
  template <class T>
  void operator()(T& x) {
    x = static_cast<T>(next());
  }
  void operator()(std::vector<CellFace>& faces) {
    faces.resize(static_cast<std::size_t>(next()));
    for (auto& f : faces) {
      (*this)(f.cell);
      (*this)(f.face);
    }
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    list.resize(static_cast<std::size_t>(next()));
    for (auto& x : list) x = static_cast<T>(next());
  }
};

/// The one list of a part's fields, for both directions.
template <class Visitor, class PartType>
void each_list(Visitor&& visit, PartType& part) {
  visit(part.positions);
  visit(part.ids);
  visit(part.owners);
  visit(part.pieces);
  visit(part.owned_cells);
  visit(part.types);
  visit(part.cell_vertices);
  visit(part.numbers);
  visit(part.cell_ids);
  visit(part.regions);
  visit(part.boundary);
}

std::vector<std::int64_t> pack(const Part& part) {
  Packer packer;
  each_list(packer, part);
  packer(static_cast<std::int64_t>(part.sets.size()));
  for (const auto& set : part.sets) {
    packer(set.vertices);
    packer(set.faces);
    packer(static_cast<std::int64_t>(set.has_faces));
  }
  packer(static_cast<std::int64_t>(part.supports.size()));
  for (const auto& support : part.supports) {
    packer(support.vertices);
    for (const bool fixed : support.held) packer(static_cast<std::int64_t>(fixed));
  }
  return std::move(packer.words);
}

Part unpack(const std::vector<std::int64_t>& words) {
  Part part;
  Unpacker unpacker{words};
  each_list(unpacker, part);
  part.sets.resize(static_cast<std::size_t>(unpacker.next()));
  for (auto& set : part.sets) {
    unpacker(set.vertices);
    unpacker(set.faces);
    unpacker(set.has_faces);
  }
  part.supports.resize(static_cast<std::size_t>(unpacker.next()));
  for (auto& support : part.supports) {
    unpacker(support.vertices);
    for (bool& fixed : support.held) unpacker(fixed);
  }
  return part;
}

template <class T>
void send(MPI_Comm comm, const std::vector<T>& values, int to) {
  MPI_Send(values.data(), static_cast<int>(values.size()), parallel::mpi_type<T>(), to, 0, comm);
}

template <class T>
std::vector<T> receive(MPI_Comm comm, int from) {
  MPI_Status status;
  int count = 0;
  MPI_Probe(from, 0, comm, &status);
  MPI_Get_count(&status, parallel::mpi_type<T>(), &count);
  std::vector<T> values(static_cast<std::size_t>(count));
  MPI_Recv(values.data(), count, parallel::mpi_type<T>(), from, 0, comm, MPI_STATUS_IGNORE);
  return values;
}

}  // namespace

void send_part(MPI_Comm comm, const Part& part, int to) {
  send(comm, pack(part), to);
  send(comm, part.points, to);
}

Part receive_part(MPI_Comm comm, int from) {
  Part part = unpack(receive<std::int64_t>(comm, from));
  part.points = receive<double>(comm, from);
  return part;
}

void broadcast_shared(MPI_Comm comm, Shared& shared) {
  std::vector<std::int64_t> counts = {shared.vertices_total, shared.cells_total,     shared.dropped_vertices,
                                      shared.pieces,         shared.connected_parts, shared.hanging_faces};
  parallel::broadcast(comm, counts);
  shared.vertices_total = counts[0];
  shared.cells_total = counts[1];
  shared.dropped_vertices = counts[2];
  shared.pieces = static_cast<int>(counts[3]);
  shared.connected_parts = static_cast<int>(counts[4]);
  shared.hanging_faces = counts[5];
  parallel::broadcast(comm, shared.set_names);
  parallel::broadcast(comm, shared.notes);

  std::vector<std::string> names, laws, unread_laws, unread_densities, parts;  // no law: an empty name
  std::vector<std::int64_t> overlaps;  // two a region: how its parts overlap, and how many there are
  std::vector<double> materials, law_values, points;
  std::vector<std::int64_t> joints;
  for (const auto& region : shared.regions) {
    names.push_back(region.name);
    for (const auto& constant : {region.material.young, region.material.poisson, region.material.density})
      materials.insert(materials.end(), {constant ? 1.0 : 0.0, constant.value_or(0)});
    const auto& law = region.material.law;
    laws.push_back(law ? fem::name(*law) : "");
    if (law)
      for (const auto& parameter : fem::parameters(*law)) law_values.push_back(parameter.value);
    unread_laws.push_back(region.material.unread_law);
    unread_densities.push_back(region.material.unread_density);
    parts.insert(parts.end(), region.parts.begin(), region.parts.end());
    overlaps.insert(overlaps.end(), {static_cast<std::int64_t>(region.overlap), std::ssize(region.parts)});
  }
  Packer packer;
  for (const auto& joint : shared.joints) {
    points.insert(points.end(), joint.point.begin(), joint.point.end());
    packer(joint.pieces);
  }
  parallel::broadcast(comm, names);
  parallel::broadcast(comm, laws);
  parallel::broadcast(comm, law_values);
  parallel::broadcast(comm, unread_laws);
  parallel::broadcast(comm, unread_densities);
  parallel::broadcast(comm, parts);
  parallel::broadcast(comm, overlaps);
  parallel::broadcast(comm, materials);
  parallel::broadcast(comm, points);
  parallel::broadcast(comm, packer.words);
  if (parallel::rank(comm) == 0) return;

  auto part = parts.begin();
  auto law_value = law_values.begin();
  for (std::size_t r = 0; r < names.size(); ++r) {
    const auto constant = [&](std::size_t i) {
      const double* m = &materials[6 * r + 2 * i];
      return m[0] > 0 ? std::optional(m[1]) : std::nullopt;
    };
    const auto end = part + overlaps[2 * r + 1];
    shared.regions.push_back({names[r],
                              {constant(0), constant(1), constant(2),
                               fem::make_law(laws[r], [&](const fem::Parameter&) { return *law_value++; }),
                               unread_laws[r], unread_densities[r]},
                              {part, end},
                              static_cast<Overlap>(overlaps[2 * r])});
    part = end;
  }
  Unpacker unpacker{packer.words};
  for (std::size_t j = 0; 3 * j < points.size(); ++j) {
    Joint joint{{points[3 * j], points[3 * j + 1], points[3 * j + 2]}, {}};
    unpacker(joint.pieces);
    shared.joints.push_back(std::move(joint));
  }
}

}  // namespace ritz::mesh
