#include "ritz/world/rigid_motions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "ritz/fem/cell.hpp"
#include "ritz/runtime/symmetric_eigen.hpp"
#include "ritz/world/loads.hpp"

namespace ritz::world {
namespace {

using Wrench = Eigen::Matrix<double, 6, 1>;  // force, N, and torque about the centre of mass, N m

constexpr double unseen = 1e-9;       ///< share of a rigid motion's mass that a basis without it may move
constexpr double equilibrium = 1e-6;  ///< of the loads' sizes one by one
constexpr double same_area = .01;

Wrench wrench(const Eigen::Vector3d& force, const Eigen::Vector3d& arm) {
  Wrench w;
  w << force, arm.cross(force);
  return w;
}

/// The corners of the boundary faces, by rows of points: faces that one cell alone has.
std::vector<std::vector<std::int64_t>> boundary(const model::DrawnCells& cells) {
  std::map<std::vector<std::int64_t>, std::pair<int, std::vector<std::int64_t>>> faces;
  const auto add = [&](std::vector<std::int64_t> face) {
    auto key = face;
    std::ranges::sort(key);
    auto& [count, corners] = faces[key];
    ++count;
    corners = std::move(face);
  };
  for (std::size_t c = 0; c + 1 < cells.offsets.size(); ++c) {
    const auto* first = cells.vertices.data() + cells.offsets[c];
    const int vtk = cells.vtk_types[c];
    if (const auto face = fem::face_of_vtk(vtk)) add({first, first + fem::shape(*face).corners});
    if (const auto type = fem::cell_of_vtk(vtk))
      for (const auto& side : fem::shape(*type).faces) {
        std::vector<std::int64_t> face;
        for (const int corner : side.corners()) face.push_back(first[corner]);
        add(face);
      }
  }
  std::vector<std::vector<std::int64_t>> once;
  for (const auto& [key, face] : faces)
    if (face.first == 1) once.push_back(face.second);
  return once;
}

class Balance {
 public:
  explicit Balance(const model::Body& body) : body_(body), centre_(body.inertia->centre_of_mass()) {}

  /// What a load does to the body as a whole, or nothing where the model does not tell.
  std::optional<Wrench> of(const scene::Load& load) const {
    if (const auto* id = std::get_if<std::int64_t>(&load.target)) {
      const auto& ids = body_.geometry.vertex_ids;
      const auto row = std::ranges::find(ids, *id) - ids.begin();
      return row < std::ssize(ids) ? std::optional(wrench(force(load, 1), arm(row))) : std::nullopt;
    }
    const auto& name = std::get<std::string>(load.target);
    const auto& sets = body_.geometry.sets;
    const auto set = std::ranges::find(sets, name, &model::VertexSet::name);
    if (set == sets.end() || std::ssize(set->rows) < set->full_count || set->rows.empty()) return std::nullopt;
    const bool by_surface =
        std::holds_alternative<scene::Pressure>(load.kind) || std::holds_alternative<scene::Traction>(load.kind);
    return by_surface ? of_surface(load, *set) : std::optional(of_vertices(load, *set));
  }

 private:
  Eigen::Vector3d point(std::int64_t row) const { return body_.geometry.points.row(row); }
  Eigen::Vector3d arm(std::int64_t row) const { return point(row) - centre_; }

  static Eigen::Vector3d force(const scene::Load& load, double vertices) {
    if (const auto* total = std::get_if<scene::TotalForce>(&load.kind)) return vector(total->newton) / vertices;
    return vector(std::get<scene::EachForce>(load.kind).newton);
  }

  Wrench of_vertices(const scene::Load& load, const model::VertexSet& set) const {
    Wrench sum = Wrench::Zero();
    for (const auto row : set.rows) sum += wrench(force(load, static_cast<double>(set.full_count)), arm(row));
    return sum;
  }

  std::optional<Wrench> of_surface(const scene::Load& load, const model::VertexSet& set) const {
    const std::set<std::int64_t> rows(set.rows.begin(), set.rows.end());
    Wrench sum = Wrench::Zero();
    double area = 0;
    for (const auto& face : boundary(body_.geometry.cells)) {
      if (!std::ranges::all_of(face, [&](auto row) { return rows.contains(row); })) continue;
      for (std::size_t i = 1; i + 1 < face.size(); ++i) {  // a fan of triangles
        const Eigen::Vector3d a = arm(face[0]), b = arm(face[i]), c = arm(face[i + 1]);
        const Eigen::Vector3d outward = (b - a).cross(c - a) / 2;
        area += outward.norm();
        const auto* pressure = std::get_if<scene::Pressure>(&load.kind);
        const Eigen::Vector3d push =
            pressure ? Eigen::Vector3d(-pressure->pascal * outward)
                     : Eigen::Vector3d(outward.norm() * vector(std::get<scene::Traction>(load.kind).pascal));
        sum += wrench(push, (a + b + c) / 3);
      }
    }
    const auto stored = std::ranges::find(body_.loads, set.name, &model::SetLoad::set);
    if (stored == body_.loads.end() || std::abs(area - stored->area) > same_area * stored->area) return std::nullopt;
    return sum;
  }

  const model::Body& body_;
  Eigen::Vector3d centre_;
};

/// What of a wrench drives rigid motions: all of M-normalised ones, and (rows) those that U does not see.
struct Unseen {
  Eigen::Matrix<double, 6, 6> scaling;
  Eigen::MatrixXd motions;
};

Unseen unseen_motions(const model::Inertia& inertia) {
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(6, 6);
  G.topLeftCorner<3, 3>().diagonal().setConstant(inertia.mass());
  G.bottomRightCorner<3, 3>() = inertia.tensor();
  const auto [weights, axes] = runtime::symmetric_eigen(G);
  const Eigen::MatrixXd scaling = axes * weights.cwiseSqrt().cwiseInverse().asDiagonal() * axes.transpose();
  const Eigen::MatrixXd seen = inertia.rigid_coupling() * scaling;
  const auto [shares, directions] = runtime::symmetric_eigen(seen.transpose() * seen);
  const auto count = (shares.array() < unseen).count();
  return {scaling, directions.leftCols(count).transpose() * scaling};
}

/// Loads that share a factor over time.
struct Term {
  const std::optional<scene::Table>* table;
  Eigen::VectorXd drive;
  double size;  ///< were all rigid motions unseen
};

bool in_equilibrium(const scene::Scene& scene, const std::vector<Term>& terms) {
  std::set<double> times = {0, 1};
  for (const auto& term : terms)
    if (*term.table)
      for (const auto& [t, value] : (*term.table)->points) times.insert(t);
  for (const double t : times) {  // between them all factors are linear
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(terms.front().drive.size());
    double sizes = 0;
    for (const auto& term : terms) {
      const double factor = scene::factor(scene, *term.table, t);
      sum += factor * term.drive;
      sizes += std::abs(factor) * term.size;
    }
    if (sum.norm() > equilibrium * sizes) return false;
  }
  return true;
}

}  // namespace

bool lacks_motions(const model::Body& body) {
  return body.reduction && body.modes &&
         std::ranges::count(body.modes->kinds, model::ModeKind::rigid) >
             (body.reduction->stiffness.array() == 0).count();
}

std::optional<LeftOut> left_out_motions(const scene::Scene& scene, const model::Body& body) {
  if (!lacks_motions(body) || (scene.loads.empty() && !scene.gravity && !scene.shake)) return std::nullopt;
  const auto rigid = std::ranges::count(body.modes->kinds, model::ModeKind::rigid);
  const Unseen unseen_by_u = unseen_motions(*body.inertia);
  const auto& scaling = unseen_by_u.scaling;
  const auto& motions = unseen_by_u.motions;
  if (motions.rows() < rigid) return LeftOut{rigid, Push::may_move_pieces};
  const Balance balance(body);
  const std::optional<scene::Table> constant;
  std::optional<scene::Table> shaking;
  std::vector<Term> terms;
  for (const auto& load : scene.loads) {
    const auto wrench = balance.of(load);
    if (!wrench) return LeftOut{rigid, Push::cannot_be_told};
    terms.push_back({&load.table, motions * *wrench, (scaling * *wrench).norm()});
  }
  const auto add_field = [&](const scene::Vector3& acceleration, const std::optional<scene::Table>& table) {
    const Eigen::Vector3d force = body.inertia->mass() * vector(acceleration);
    terms.push_back({&table, motions.leftCols<3>() * force, (scaling.leftCols<3>() * force).norm()});
  };
  if (scene.gravity) add_field(*scene.gravity, constant);
  if (scene.shake) add_field(scene.shake->direction, shaking = scene.shake->table);
  if (in_equilibrium(scene, terms)) return std::nullopt;
  return LeftOut{rigid, Push::moves_the_whole};
}

}  // namespace ritz::world
