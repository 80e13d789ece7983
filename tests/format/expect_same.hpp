// Two models are the same, to the last bit.
#pragma once
#include <gtest/gtest.h>

#include "ritz/model/model.hpp"

namespace ritz::test {

inline void expect_same(const model::Geometry& a, const model::Geometry& b) {
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.full_vertices, b.full_vertices);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.vertex_ids, b.vertex_ids);
  EXPECT_EQ(a.cells.vtk_types, b.cells.vtk_types);
  EXPECT_EQ(a.cells.offsets, b.cells.offsets);
  EXPECT_EQ(a.cells.vertices, b.cells.vertices);
  ASSERT_EQ(a.sets.size(), b.sets.size());
  for (std::size_t i = 0; i < a.sets.size(); ++i) {
    EXPECT_EQ(a.sets[i].name, b.sets[i].name);
    EXPECT_EQ(a.sets[i].rows, b.sets[i].rows);
    EXPECT_EQ(a.sets[i].full_count, b.sets[i].full_count);
  }
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    EXPECT_EQ(a.materials[i].region, b.materials[i].region);
    const fem::Material &one = a.materials[i].material, &other = b.materials[i].material;
    EXPECT_EQ(one.density, other.density);
    EXPECT_STREQ(fem::name(one.law), fem::name(other.law));
    const auto values = fem::parameters(one.law), others = fem::parameters(other.law);
    ASSERT_EQ(values.size(), others.size());
    for (std::size_t n = 0; n < values.size(); ++n) EXPECT_EQ(values[n].value, others[n].value);
  }
}

inline void expect_same(const std::optional<model::Modes>& a, const std::optional<model::Modes>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->eigenvalues, b->eigenvalues);
  EXPECT_EQ(a->energies, b->energies);
  EXPECT_EQ(a->residuals, b->residuals);
  EXPECT_EQ(a->floor_applies, b->floor_applies);
  EXPECT_EQ(a->kinds, b->kinds);
  EXPECT_EQ(a->orthonormality, b->orthonormality);
  EXPECT_EQ(a->certificate.kind, b->certificate.kind);
  EXPECT_EQ(a->certificate.shift, b->certificate.shift);
  EXPECT_EQ(a->certificate.counted, b->certificate.counted);
  EXPECT_EQ(a->certificate.found, b->certificate.found);
}

inline void expect_same(const std::optional<model::Reduction>& a, const std::optional<model::Reduction>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->stiffness, b->stiffness);
  EXPECT_EQ(a->singular_values, b->singular_values);
  EXPECT_EQ(a->discarded, b->discarded);
  EXPECT_EQ(a->residual_vectors, b->residual_vectors);
}

inline void expect_same(const std::optional<model::Polynomial>& a, const std::optional<model::Polynomial>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->r, b->r);
  EXPECT_EQ(a->quadratic, b->quadratic);
  EXPECT_EQ(a->cubic, b->cubic);
  EXPECT_EQ(a->quartic, b->quartic);
}

inline void expect_same(const std::optional<model::Cubature>& a, const std::optional<model::Cubature>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->integrand, b->integrand);
  EXPECT_EQ(a->cells, b->cells);
  EXPECT_EQ(a->weights, b->weights);
  EXPECT_EQ(a->regions, b->regions);
  EXPECT_EQ(a->starts, b->starts);
  EXPECT_EQ(a->volumes, b->volumes);
  EXPECT_EQ(a->gradients, b->gradients);
  EXPECT_EQ(a->largest_energy, b->largest_energy);
  ASSERT_EQ(a->errors.size(), b->errors.size());
  const auto same = [](const model::PoseErrors& one, const model::PoseErrors& other) {
    EXPECT_EQ(one.root_mean_square, other.root_mean_square);
    EXPECT_EQ(one.largest, other.largest);
  };
  for (std::size_t i = 0; i < a->errors.size(); ++i) {
    EXPECT_EQ(a->errors[i].cells, b->errors[i].cells);
    same(a->errors[i].training, b->errors[i].training);
    same(a->errors[i].lifts, b->errors[i].lifts);
    same(a->errors[i].statics, b->errors[i].statics);
  }
}

inline void expect_same(const std::optional<model::Inertia>& a, const std::optional<model::Inertia>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->origin, b->origin);
  EXPECT_EQ(a->gram, b->gram);
}

inline void expect_same(const std::vector<model::SetLoad>& a, const std::vector<model::SetLoad>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].set, b[i].set);
    EXPECT_EQ(a[i].vertices, b[i].vertices);
    EXPECT_EQ(a[i].total, b[i].total);
    EXPECT_EQ(a[i].has_surface, b[i].has_surface);
    EXPECT_EQ(a[i].area, b[i].area);
    EXPECT_EQ(a[i].pressure, b[i].pressure);
    EXPECT_EQ(a[i].traction, b[i].traction);
  }
}

inline void expect_same(const model::Provenance& a, const model::Provenance& b) {
  EXPECT_EQ(a.program, b.program);
  EXPECT_EQ(a.versions, b.versions);
  EXPECT_EQ(a.options, b.options);
  EXPECT_EQ(a.ranks, b.ranks);
}

inline void expect_same(const model::Report& a, const model::Report& b) {
  ASSERT_EQ(a.seconds.size(), b.seconds.size());
  for (std::size_t i = 0; i < a.seconds.size(); ++i) {
    EXPECT_EQ(a.seconds[i].stage, b.seconds[i].stage);
    EXPECT_EQ(a.seconds[i].seconds, b.seconds[i].seconds);
  }
  EXPECT_EQ(a.figures, b.figures);
  EXPECT_EQ(a.notes, b.notes);
  EXPECT_EQ(a.mesh_errors, b.mesh_errors);
}

inline void expect_same(const model::Body& a, const model::Body& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.checksums.mesh, b.checksums.mesh);
  EXPECT_EQ(a.checksums.problem, b.checksums.problem);
  expect_same(a.geometry, b.geometry);
  EXPECT_EQ(a.basis.U, b.basis.U);
  expect_same(a.modes, b.modes);
  expect_same(a.reduction, b.reduction);
  expect_same(a.polynomial, b.polynomial);
  expect_same(a.cubature, b.cubature);
  expect_same(a.inertia, b.inertia);
  expect_same(a.loads, b.loads);
  expect_same(a.report, b.report);
}

inline void expect_same(const model::Model& a, const model::Model& b) {
  expect_same(a.provenance, b.provenance);
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) expect_same(a.bodies[i], b.bodies[i]);
}

}  // namespace ritz::test
