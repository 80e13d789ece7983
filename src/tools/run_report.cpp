#include "run_report.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/files/summary.hpp"

namespace ritz::tools {
namespace {

constexpr const char* not_finite_linear = ", is not finite: the loads are too large for double precision";

std::string end_of_time(const world::Failure& failure, const model::Body& body) {
  const std::string at = "step " + std::to_string(failure.step) + ", t = " + std::to_string(failure.t);
  if (!is_nonlinear(body)) return at + not_finite_linear;
  return at + (failure.cause == world::Cause::not_finite
                   ? " s, is not finite: the loads are too large, or turn a cell inside out"
                   : " s, does not converge, nor do its halves: take shorter steps");
}

std::string end_of_statics(const world::Failure& failure, const model::Body& body) {
  if (!is_nonlinear(body))
    return "load step " + std::to_string(failure.step) + ", t = " + std::to_string(failure.t) + not_finite_linear;
  std::ostringstream text;
  text << "statics reached load fraction " << failure.t << " and no further: ";
  if (failure.cause == world::Cause::limit_point)
    text << "a limit point, where the smallest eigenvalue of the tangent stiffness goes to zero (" << failure.softest
         << " 1/s², at rest " << failure.softest_at_rest
         << "); the body snaps or buckles there: follow it with [time] and damping";
  else text << "Newton's method does not converge; use more load steps, or [time] with damping";
  return text.str();
}

std::string free_body(const world::Failure& failure) {
  if (!failure.pushed)
    return "the body is free: a load sets it moving, so it has no state of rest; fix the body when reducing it, or use "
           "[time]";
  return "the body is free: the load pushes its rigid mode " + std::to_string(*failure.pushed + 1) +
         ", so it has no state of rest; fix the body when reducing it, or use [time]";
}

}  // namespace

std::string who(const RunBody& body) { return body.name.empty() ? "" : "body '" + body.name + "': "; }

void fail(const world::RunResult& result, const RunBody& body) {
  const auto& failure = *result.failure;
  if (failure.cause == world::Cause::free_body) throw InputError(who(body) + free_body(failure));
  if (std::holds_alternative<scene::Static>(body.scene.analysis))
    throw NumericalError(who(body) + end_of_statics(failure, *body.model));
  const auto gained = result.gain ? "; " + warning(*result.gain, std::string(result.integrator)) : "";
  throw NumericalError(who(body) + end_of_time(failure, *body.model) + gained);
}

void refuse(const world::LeftOut& left_out, const std::string& model) {
  const auto why = [&] {
    switch (left_out.push) {
      case world::Push::moves_the_whole: return "the scene's loads push or turn it as a whole";
      case world::Push::may_move_pieces: return "the scene's loads may move its pieces against each other";
      case world::Push::cannot_be_told: break;
    }
    return "whether the scene's loads push it as a whole cannot be told from what the model stores";
  };
  throw InputError("the basis of " + model + " leaves out the " + std::to_string(left_out.rigid_motions) +
                   " rigid motions of its body, which neither falls nor flies, and " + why() +
                   "; hold the body (-fix), use a model of modes alone (no -derivatives, -snapshots, -basis or "
                   "-polynomial), or ritz-full");
}

std::string balance_line(const world::EnergyBalance& balance) {
  std::ostringstream text;
  text.precision(3);
  text << "energy balance: at most " << balance.gained << " J came from nowhere and " << balance.lost
       << " J were lost (energy - energy at the start - work + damping), of " << balance.available
       << " J that there were";
  return text.str();
}

std::string overdamped(const scene::Damping& damping) {
  const auto large = std::ranges::find_if(damping.ratio, [](double ratio) { return ratio >= 1; });
  if (large == damping.ratio.end()) return "";
  return "[damping] ratio " + shown(*large) + " is overdamped, nothing swings: a ratio is a fraction of the critical " +
         "damping, and 2 % is written 0.02";
}

namespace {

/// Of the largest displacement, the error of one step beyond which a motion is not to be believed.
constexpr double too_wrong = .1;

double percent_of_motion(double error, const world::StepErrors& errors) {
  return errors.displacement > 0 ? 100 * error / errors.displacement : 0;
}

}  // namespace

std::string error_line(const world::StepErrors& errors) {
  std::ostringstream text;
  text.precision(2);
  text << "estimated error of the steps: at most " << percent_of_motion(errors.largest, errors)
       << " % of the largest displacement in one, " << percent_of_motion(errors.sum, errors)
       << " % in all, what later steps make of it not counted";
  return text.str();
}

std::string too_long(const world::StepErrors& errors, const std::string& integrator) {
  if (errors.largest <= too_wrong * errors.displacement) return "";
  std::ostringstream text;
  text.precision(2);
  text << "the steps are too long for this motion: the worst of them is wrong by an estimated "
       << percent_of_motion(errors.largest, errors) << " % of the largest displacement (" << integrator
       << "); take shorter steps";
  return text.str();
}

std::string warning(const world::EnergyGain& gain, const std::string& integrator) {
  std::ostringstream text;
  text.precision(3);
  text << "from t = " << gain.since << " s on the motion gained energy without work, up to " << 100 * gain.largest
       << " %: " << integrator << " does not hold the energy of nonlinear motions at this step; "
       << (integrator == "avf" ? "" : "say integrator = \"avf\" or \"implicit-euler\", or ") << "take shorter steps";
  return text.str();
}

std::string warning(const world::BeyondTraining& beyond, const scene::Scene& scene) {
  std::ostringstream text;
  text.precision(3);
  if (std::holds_alternative<scene::Time>(scene.analysis)) text << "from t = " << beyond.since << " s";
  else text << "from the load fraction " << beyond.since;
  text << " on the body is deformed beyond the poses that its cubature was trained on (up to " << beyond.largest
       << " times their elastic energy), where its error is not known: reduce it with a larger -cubature_amplitude";
  return text.str();
}

namespace {

using files::Json;

Json beyond(const std::optional<world::BeyondTraining>& beyond) {
  if (!beyond) return nullptr;
  return Json::Object{{"since", beyond->since}, {"largest", beyond->largest}};
}

Json energy(const std::optional<world::EnergyBalance>& balance) {
  if (!balance) return nullptr;
  return Json::Object{
      {"start", balance->start},        {"work", balance->work}, {"dissipated", balance->dissipated},
      {"gained", balance->gained},      {"lost", balance->lost}, {"largest_drift", balance->largest_drift},
      {"available", balance->available}};
}

Json errors(const std::optional<world::StepErrors>& errors) {
  if (!errors) return nullptr;
  return Json::Object{{"largest", errors->largest}, {"sum", errors->sum}, {"displacement", errors->displacement}};
}

Json::Object members(const Summarised& run, const BodyResult& body) {
  const bool timed = std::holds_alternative<scene::Time>(run.scene.analysis);
  return {{"model", body.body.model_file.string()},
          {"analysis", timed ? "dynamics" : "statics"},
          {"integrator", timed ? Json(body.result.integrator) : Json(nullptr)},
          {"precision", run.options.precision == world::Precision::float32 ? "single" : "double"},
          {"coordinates", world::reduced_size(*body.body.model)},
          {"steps", body.result.steps},
          {"newton_iterations", body.result.iterations},
          {"rejected_steps", body.result.rejected},
          {"seconds", body.result.seconds},
          {"frames", run.frames},
          {"inverted_cells", body.inverted_cells},
          {"energy", energy(body.result.energy)},
          {"step_errors", errors(body.result.errors)},
          {"beyond_training", beyond(body.result.beyond)}};
}

}  // namespace

files::Json summary(const Summarised& run) {
  const double memory = files::peak_memory();
  auto all = files::summary_head({.program = "ritz-run",
                                  .ranks = 1,
                                  .output = run.options.output.string(),
                                  .stages = {},
                                  .largest_rank = memory,
                                  .all_ranks = memory,
                                  .warnings = run.warnings});
  if (run.scene.bodies.empty()) {
    const auto own = members(run, run.bodies.front());
    all.insert(all.end(), own.begin(), own.end());
    return all;
  }
  Json::Array bodies;
  for (const auto& body : run.bodies) {
    Json::Object named{{"name", body.body.name}, {"output", body.output.string()}};
    const auto own = members(run, body);
    named.insert(named.end(), own.begin(), own.end());
    bodies.emplace_back(std::move(named));
  }
  all.emplace_back("bodies", std::move(bodies));
  return all;
}

}  // namespace ritz::tools
