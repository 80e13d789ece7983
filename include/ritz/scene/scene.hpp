// A scene: the bodies and what is done to them, in plain structs. scene_file reads it from TOML; the serial
// and the parallel programs use it. SI units throughout.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ritz::scene {

using Vector3 = std::array<double, 3>;

enum class Integrator {
  exact,
  implicit_euler,
  newmark,
  generalized_alpha,
  bdf2,
  central_difference,
  avf,
  linearly_implicit
};

/// As scene files spell them, in the order of the enumeration.
inline constexpr std::array<std::string_view, 8> integrator_names = {
    "exact", "implicit-euler",     "newmark", "generalized-alpha",
    "bdf2",  "central-difference", "avf",     "linearly-implicit"};

/// Piecewise linear in time: (t, value) pairs, t strictly ascending, at least one; the first value holds before, the
/// last one after.
struct Table {
  std::vector<std::pair<double, double>> points;
  double at(double t) const;
  bool operator==(const Table&) const = default;
};

/// Where something acts: a named set, or one vertex by the mesh file's own number.
using Target = std::variant<std::string, std::int64_t>;

struct TotalForce {
  Vector3 newton;
};  ///< shared equally by all vertices of the target
struct EachForce {
  Vector3 newton;
};  ///< on every vertex of the target
struct Pressure {
  double pascal;
};  ///< on a surface set, positive pushes into the body
struct Traction {
  Vector3 pascal;
};  ///< on a surface set, consistent

struct StaticStart {};  ///< at rest, in equilibrium under the loads at t = 0

/// z and z' of a reduced model. An empty list: zeros.
struct CoordinateStart {
  std::vector<double> z;         ///< √kg m
  std::vector<double> velocity;  ///< √kg m/s
};

/// A state of a motion file.
struct StoredStart {
  std::filesystem::path motion;
  std::optional<double> time;   ///< of that motion, s; absent: its last state
  std::filesystem::path model;  ///< for the full model: the reduced model that the motion is of; empty: none
};

/// How a motion starts, at t = 0.
using Initial = std::variant<StaticStart, CoordinateStart, StoredStart>;

/// A body of a scene that names its bodies. Several bodies may have the same model.
struct Body {
  std::string name;
  std::filesystem::path model;          ///< the model file; empty: the one on the command line
  std::string model_body;               ///< the name of the body in that file; empty: the first one
  std::optional<Initial> initial = {};  ///< absent: that of the scene
};

struct Load {
  Target target;
  std::variant<TotalForce, EachForce, Pressure, Traction> kind;
  std::optional<Table> table;  ///< a factor over time; absent: constant 1, in statics the load fraction
  std::string body = {};       ///< the body it acts on; empty in a scene that names no bodies
};

/// Ground acceleration direction * table(t) m/s² of all supports (the direction is not normalised); motion is then
/// relative to the ground.
struct Shake {
  Vector3 direction;
  Table table;
};

struct Damping {
  double alpha = 0;                ///< 1/s, D = alpha M + beta K
  double beta = 0;                 ///< s
  std::vector<double> ratio = {};  ///< modal damping ratios, one a flexible mode, the last one held; adds to the rest
};

/// t = 0, step, 2 step, ... up to the first that reaches `end`.
struct Time {
  double step;
  double end;
  std::optional<Integrator> integrator;  ///< absent: the model's default
};

/// Load fractions t = 1/steps, 2/steps, ... 1: constant loads and gravity are multiplied by t; a load with a table by
/// table(t) instead.
struct Static {
  int steps;
};

/// What a probe measures: m, m/s or m/s², relative to the ground where that shakes.
enum class Quantity { displacement, velocity, acceleration };

/// As scene files spell them, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> quantity_names = {"displacement", "velocity", "acceleration"};

struct Probe {
  std::string name;
  Target target;          ///< a set: the plain mean over its vertices
  std::string body = {};  ///< the body that it is on; empty in a scene that names no bodies
  std::vector<Quantity> quantities = {Quantity::displacement};  ///< in statics displacements alone
};

/// The columns of a table of these probes, one after another: NAME_ux, NAME_uy, NAME_uz for displacements, NAME_vx, …
/// for velocities, NAME_ax, … for accelerations.
std::vector<std::string> probe_columns(const std::vector<Probe>& probes);

/// Whether any of these probes measures `quantity`.
bool any_measures(const std::vector<Probe>& probes, Quantity quantity);

struct Scene {
  std::variant<Time, Static> analysis;
  Damping damping;
  std::optional<Vector3> gravity;  ///< m/s²
  std::optional<Shake> shake;
  std::optional<Initial> initial = {};  ///< absent: a motion starts at rest, undeformed
  std::vector<Body> bodies = {};        ///< none: there is one body, which has no name
  std::vector<Load> loads;
  std::vector<Probe> probes;
};

/// The scene of one body: a scene that names no bodies, with the loads and probes of this body alone, and with its own
/// start if it has one. Gravity, shaking and damping are the same for all bodies.
Scene of_body(const Scene& scene, std::string_view name);

/// The number of steps that reach `end`. A shortfall of 1e-9 of a step is ignored, so that 1 s in steps of 0.1 s is ten
/// steps.
std::int64_t step_count(const Time& time);

/// The factor of a load with this table at time t (s) or load fraction t; without a table that of a constant load, and
/// of gravity.
double factor(const Scene& scene, const std::optional<Table>& table, double t);

/// What the user asked for; if neither member is set: all states, but at most 201 frames.
struct FrameChoice {
  std::optional<std::int64_t> frames;  ///< the number of frames, evenly spread
  std::optional<std::int64_t> every;   ///< one frame every so many steps
};

/// The number of frames of a run of `steps` steps.
std::int64_t frame_count(const FrameChoice& choice, std::int64_t steps);

/// The states that are frames, ascending; states are numbered 0 ... steps. With `every`: 0, every, 2 every, ...; with
/// `frames`: so many, spread evenly from the first state to the last (a single frame is the last state); by default as
/// with `frames` = 201, or all states if there are fewer.
std::vector<std::int64_t> frame_schedule(const FrameChoice& choice, std::int64_t steps);

}  // namespace ritz::scene
