#include "ritz/stages/rigid_modes.hpp"

#include <Eigen/QR>

#include "ritz/algebra/dense.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::stages {
namespace {

using Motion = Eigen::Matrix<double, mesh::components, 6>;

/// Where each piece is and how large: rotations are taken about its centre and scaled by its size, so that the small
/// matrix of constraints is well conditioned.
struct Frames {
  Eigen::Matrix3Xd centres;
  Eigen::VectorXd sizes;

  /// Displacement at x of the unit translations and scaled rotations of a piece.
  Motion motion(int piece, const Eigen::Vector3d& x) const {
    const Eigen::Vector3d r = (x - centres.col(piece)) / sizes[piece];
    Motion R;
    R << 1, 0, 0, 0, r.z(), -r.y(),  //
        0, 1, 0, -r.z(), 0, r.x(),   //
        0, 0, 1, r.y(), -r.x(), 0;
    return R;
  }
};

/// Calls visit(piece, point) for all vertices of all pieces, on one rank each: a vertex that pieces share once a piece.
template <class Visit>
void each_vertex(const mesh::Mesh& mesh, Visit visit) {
  for (int v = 0; v < mesh.owned; ++v)
    visit(mesh.vertex_pieces[static_cast<std::size_t>(v)], Eigen::Vector3d(mesh.points.col(v)));
  if (parallel::rank(mesh.comm) != 0) return;
  for (const auto& joint : mesh.joints)  // all ranks know them; their first piece is the one in vertex_pieces
    for (std::size_t i = 1; i < joint.pieces.size(); ++i) visit(joint.pieces[i], Eigen::Vector3d(joint.point.data()));
}

Frames frames(const mesh::Mesh& mesh) {
  Frames f{Eigen::Matrix3Xd::Zero(3, mesh.pieces), Eigen::VectorXd::Zero(mesh.pieces)};
  // Sums are taken relative to one vertex that all ranks know, so that far coordinates lose nothing.
  Eigen::Vector3d origin = mesh.owned > 0 ? Eigen::Vector3d(mesh.points.col(0)) : Eigen::Vector3d::Zero();
  const int first = parallel::min(mesh.comm, mesh.owned > 0 ? parallel::rank(mesh.comm) : parallel::size(mesh.comm));
  MPI_Bcast(origin.data(), 3, MPI_DOUBLE, first, mesh.comm);
  Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(1, mesh.pieces), sums = Eigen::MatrixXd::Zero(3, mesh.pieces);
  each_vertex(mesh, [&](int p, const Eigen::Vector3d& x) {
    sums.col(p) += x - origin;
    counts(0, p) += 1;
  });
  parallel::sum_in_place(mesh.comm, counts);
  parallel::sum_in_place(mesh.comm, sums);
  for (int p = 0; p < mesh.pieces; ++p) f.centres.col(p) = origin + sums.col(p) / counts(0, p);
  each_vertex(
      mesh, [&](int p, const Eigen::Vector3d& x) { f.sizes[p] = std::max(f.sizes[p], (x - f.centres.col(p)).norm()); });
  MPI_Allreduce(MPI_IN_PLACE, f.sizes.data(), mesh.pieces, MPI_DOUBLE, MPI_MAX, mesh.comm);
  return f;
}

/// Rows that say "this motion vanishes here" at fixed degrees of freedom: 6 a piece, as the triangle of a QR.
Eigen::MatrixXd support_rows(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Frames& frames) {
  std::vector<Eigen::Matrix<double, 6, 6>> triangles(static_cast<std::size_t>(mesh.pieces),
                                                     Eigen::Matrix<double, 6, 6>::Zero());
  for (int v = 0; v < mesh.owned; ++v) {
    const int p = mesh.vertex_pieces[static_cast<std::size_t>(v)];
    const Motion R = frames.motion(p, mesh.points.col(v));
    for (int c = 0; c < mesh::components; ++c) {
      if (!dofs.fixed(v, c)) continue;
      Eigen::MatrixXd stacked(7, 6);  // of no fixed size: the compiler would take a minute to unroll the factorization
      auto& triangle = triangles[static_cast<std::size_t>(p)];
      stacked << triangle, R.row(c);
      triangle = Eigen::HouseholderQR<Eigen::MatrixXd>(stacked).matrixQR().topRows<6>();
      triangle.triangularView<Eigen::StrictlyLower>().setZero();
    }
  }
  std::vector<double> mine;
  for (const auto& t : triangles) mine.insert(mine.end(), t.data(), t.data() + t.size());
  const auto all = parallel::gather_all(mesh.comm, mine);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(all.size()) / 6, 6 * mesh.pieces);
  for (Eigen::Index block = 0; block < rows.rows() / 6; ++block)
    rows.block<6, 6>(6 * block, 6 * (block % mesh.pieces)) =
        Eigen::Map<const Eigen::Matrix<double, 6, 6>>(all.data() + 36 * block);
  return rows;
}

/// Rows that say "two pieces move alike here" at vertices that they share.
Eigen::MatrixXd joint_rows(const mesh::Mesh& mesh, const Frames& frames) {
  Eigen::Index count = 0;
  for (const auto& joint : mesh.joints)
    count += mesh::components * (static_cast<Eigen::Index>(joint.pieces.size()) - 1);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, 6 * mesh.pieces);
  Eigen::Index at = 0;
  for (const auto& joint : mesh.joints) {
    const Eigen::Vector3d x(joint.point.data());
    for (std::size_t i = 1; i < joint.pieces.size(); ++i, at += 3) {
      rows.block<mesh::components, 6>(at, 6 * joint.pieces[0]) = frames.motion(joint.pieces[0], x);
      rows.block<mesh::components, 6>(at, 6 * joint.pieces[i]) = -frames.motion(joint.pieces[i], x);
    }
  }
  return rows;
}

/// The triangle of a tall matrix's QR: the same null space in at most as many rows as columns.
Eigen::MatrixXd condensed(const Eigen::MatrixXd& rows) {
  if (rows.rows() <= rows.cols()) return rows;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows);
  return qr.matrixQR().topRows(rows.cols()).triangularView<Eigen::Upper>();
}

/// An orthonormal basis of the null space that leans on the coordinate motions in their order: projections of the unit
/// vectors, orthogonalised one after the other. A free piece keeps its plain translations and rotations.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& constraints) {
  constexpr double tolerance = 1e-9;
  const auto n = constraints.cols();
  if (constraints.rows() == 0 || constraints.cwiseAbs().maxCoeff() == 0) return Eigen::MatrixXd::Identity(n, n);
  const auto [sigma, V] = algebra::right_singular_vectors(constraints);
  const auto rank = (sigma.array() > tolerance * sigma[0]).count();
  const Eigen::MatrixXd N = V.rightCols(n - rank);
  Eigen::MatrixXd basis(n, n - rank);
  Eigen::Index found = 0;
  for (Eigen::Index i = 0; i < n && found < basis.cols(); ++i) {
    Eigen::VectorXd v = N * N.row(i).transpose();
    for (int pass = 0; pass < 2; ++pass) v -= basis.leftCols(found) * (basis.leftCols(found).transpose() * v);
    if (v.norm() > 1e-3) basis.col(found++) = v.normalized();
  }
  return basis.leftCols(found);
}

algebra::Tall evaluate(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Frames& frames,
                       const Eigen::MatrixXd& coordinates) {
  algebra::Tall u(mesh::components * mesh.owned, coordinates.cols());
  for (int v = 0; v < mesh.owned; ++v) {
    const int p = mesh.vertex_pieces[static_cast<std::size_t>(v)];
    mesh::at_vertex(u, v) = frames.motion(p, mesh.points.col(v)) * coordinates.middleRows<6>(6 * p);
  }
  return mesh::from_vertices(mesh, dofs, u);
}

}  // namespace

mesh::FreeRows rigid_motions(const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  const Frames f = frames(mesh);
  const Eigen::MatrixXd joints = condensed(joint_rows(mesh, f)), supports = condensed(support_rows(mesh, dofs, f));
  Eigen::MatrixXd constraints(joints.rows() + supports.rows(), 6 * mesh.pieces);
  constraints << joints, supports;
  return evaluate(mesh, dofs, f, null_space(constraints));
}

mesh::FreeRows near_null_space(const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  Frames f = frames(mesh);
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(6 * mesh.pieces, 6);
  for (int p = 0; p < mesh.pieces; ++p) together.middleRows<6>(6 * p).setIdentity();
  f.centres = f.centres.rowwise().mean().replicate(1, mesh.pieces).eval();
  f.sizes.setConstant(f.sizes.maxCoeff());
  return evaluate(mesh, dofs, f, together);
}

}  // namespace ritz::stages
