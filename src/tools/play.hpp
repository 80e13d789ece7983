// The run of a scene without a word printed, for whoever wants its states: ritz-run, or a program in Python.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "run_report.hpp"

namespace ritz::tools {

/// Whether a run writes its motion and tables, or only tells its listener.
enum class Files : unsigned char { none, written };

/// What a run tells as it goes.
struct Listener {
  std::function<void(const std::string& text)> warning;
  /// A state of body `body`, counted as the scene has them: t in s or load fractions, z of r numbers. May be empty.
  std::function<void(std::size_t body, double t, const Eigen::Ref<const Eigen::VectorXd>& z)> state;
};

/// A run that reached its end.
struct Played {
  std::vector<BodyResult> bodies;  ///< in the order of the scene
  std::int64_t frames = 0;         ///< that each motion file has
  std::string replaced;  ///< a sentence on files of an earlier run that were replaced; empty if there are none
};

/// Runs a scene on its bodies, as `cast` returns them; reads the models of those that have none yet. `options.scene` is
/// only the name of the scene's file, which must not be overwritten; empty if there is none. Prints nothing but the
/// line of progress. Throws as run.
Played play(const RunOptions& options, const scene::Scene& scene, std::vector<RunBody> bodies, Files files,
            const Listener& listener);

}  // namespace ritz::tools
