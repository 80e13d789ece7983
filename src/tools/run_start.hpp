// Where the bodies of a run start: with a state of a motion file that [initial] names, or where an earlier run stopped
// (--restart).
#pragma once
#include <optional>
#include <vector>

#include "ritz/files/claim.hpp"
#include "ritz/format/motion.hpp"
#include "ritz/world/run.hpp"
#include "run.hpp"
#include "run_body.hpp"

namespace ritz::tools {

/// The motion file of a body, where `option` names `all`: MOTION.NAME.h5 of the body NAME in a scene that names its
/// bodies; else `all` itself. Throws InputError for a folder.
std::filesystem::path motion_of(const std::filesystem::path& all, const std::string& option, const RunBody& body);

/// The motion that the body's [initial] names, if it does.
std::optional<files::Named> stored_start(const RunBody& body);

/// How the bodies start, which have their models. Throws InputError for a motion of another model or scene, for a time
/// that it has no state of, and for bodies that stopped at different times.
std::vector<world::Start> starts(const RunOptions& options, const std::vector<RunBody>& bodies);

/// How many steps of the scene are behind these starts.
std::int64_t steps_behind(const std::vector<world::Start>& starts);

/// The end of a motion, for --restart of another run.
format::ReducedState end_of(const RunOptions& options, const RunBody& body, const world::RunResult& result);

}  // namespace ritz::tools
