// What the scene of a step is made of.
#pragma once
#include "ritz/readers/file_scene.hpp"
#include "ritz/readers/inp_model.hpp"

namespace ritz::readers {

/// The step whose scene is made.
struct InpAnalysis {
  std::size_t step;  ///< position in InpModel::steps
  bool motion;       ///< else statics
  double increment;  ///< the first one, in the deck's time
  double period;
  std::optional<double> before;  ///< the time of all steps before; nothing where one of them has none
  bool ramped;                   ///< a load without an amplitude grows in proportion over the step
};

/// Finds the step, reads its procedure, and notes what of it no scene has. Throws InputError.
InpAnalysis inp_analysis(const Sources& sources, InpModel& model, std::optional<int> step);

enum class InpAction { force, pressure, traction, gravity };

/// A load that a scene has.
struct InpActing {
  const InpLoad* load;
  std::size_t step;  ///< the one that it stands in
  InpAction action;
  std::vector<Index> on = {};        ///< 3 v + component of a force, faces, cells of gravity: ascending
  std::string set = {};              ///< kind and name in capitals of the set that it acts on (InpModel::set_index)
  std::optional<Index> vertex = {};  ///< or the file's number of the only vertex
};

/// Finds what the loads of all steps act on; loads that act on nothing are taken out. A face has the same number
/// wherever it is listed. Throws InputError, also for pressure inside the body.
void find_targets(const Sources& sources, InpModel& model, std::vector<std::vector<InpActing>>& steps);

/// The loads in effect in the step, in the order of the file. Throws InputError for what no scene has and -ignore does
/// not name.
std::vector<InpActing> inp_loads(const Sources& sources, InpModel& model, const InpAnalysis& analysis);

/// The factor of a load over the step: the deck's time from the beginning of the step or, in statics, a fraction of the
/// step. Nothing where it is that of a scene's load without a table. `magnitude` is the load's. Throws InputError.
std::optional<scene::Table> inp_factor(const Sources& sources, const InpModel& model, const InpAnalysis& analysis,
                                       const InpActing& acting, double magnitude);

/// The keyword above a load's line.
const Keyword& keyword_of(const InpModel& model, const InpLoad& load);

/// The type of a load (P2, GRAV), or its degree of freedom.
std::string label_of(const InpLoad& load);

/// The number in field `at` of a line, 0 where it is blank or absent. Throws InputError.
double inp_number(const Sources& sources, const std::vector<Line>& fields, std::size_t at, std::string_view what);

/// Magnitude and unit direction of GRAV and TRVEC. Throws InputError.
scene::Vector3 inp_vector(const Sources& sources, const InpLoad& load);

}  // namespace ritz::readers
