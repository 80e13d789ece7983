// A file of every released version of the format stays readable. New ones are made by write_sample_model.
#include <gtest/gtest.h>

#include "format/expect_same.hpp"
#include "format/temporary.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/format/reader.hpp"
#include "support/sample_model.hpp"

namespace ritz::format {
namespace {

/// The sample as it was before modes had an error by the mesh (version 1.4).
model::Model without_mesh_errors() {
  auto model = test::sample_model();
  model.bodies[0].report.mesh_errors.resize(0);
  return model;
}

TEST(Fixture, OfVersion10IsRead) {
  const ModelReader in(std::filesystem::path(RITZ_SOURCE "/tests/format/fixtures/model-1.0.h5"));
  EXPECT_EQ(in.version().minor, 0);
  auto expected = without_mesh_errors();
  expected.bodies[0].geometry.materials[1].material.law = fem::StVK{1e6, .49};  // laws had no names then
  test::expect_same(read(in), expected);
  for (const auto& info : contents(in)) EXPECT_NO_THROW(verify(in, info));
}

/// Before a file could have several bodies, what is now the first body's own was the file's.
TEST(Fixture, OfVersion12IsRead) {
  const ModelReader in(std::filesystem::path(RITZ_SOURCE "/tests/format/fixtures/model-1.2.h5"));
  EXPECT_EQ(in.version().minor, 2);
  test::expect_same(read(in), without_mesh_errors());
  for (const auto& info : contents(in)) EXPECT_NO_THROW(verify(in, info));
}

/// Before a reduction could have residual vectors, and modes an error by the mesh.
TEST(Fixture, OfVersion13IsRead) {
  const ModelReader in(std::filesystem::path(RITZ_SOURCE "/tests/format/fixtures/model-1.3.h5"));
  EXPECT_EQ(in.version().minor, 3);
  test::expect_same(read(in), without_mesh_errors());
  for (const auto& info : contents(in)) EXPECT_NO_THROW(verify(in, info));
}

}  // namespace
}  // namespace ritz::format
