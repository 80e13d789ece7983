// The loads on named sets, and gravity, whose static answers a run of ritz-reduce solves for: for residual vectors, and
// to say what the basis misses of them.
#pragma once
#include <string>
#include <vector>

#include "ritz/config/config.hpp"
#include "ritz/files/json.hpp"
#include "ritz/stages/static_answers.hpp"

namespace ritz::app {

/// The places that -residual_vectors names. Throws InputError for a set that the mesh does not have (naming the nearest
/// one), that is ambiguous, or that is empty.
std::vector<stages::LoadPlace> residual_places(const config::Config& config, const mesh::Mesh& mesh);

/// *Collective*. The places whose answers are solved for: all sets with vertices and gravity where that is asked for or
/// costs little, that is, with one block of solves by a factorization that is exact; else `residual`.
std::vector<stages::LoadPlace> answered_places(const config::Config& config, const stages::Problem& problem,
                                               stages::Strategy strategy,
                                               const std::vector<stages::LoadPlace>& residual);

/// The columns of the answers that belong to some of the places.
algebra::Tall answers_at(const std::vector<stages::LoadPlace>& some, const stages::UnitLoads& loads,
                         mesh::FreeRef answers);

/// Which static answers the basis misses more than 1 % of, worst first, and what to do about it; and which of the
/// `residual` places bear their load without an answer. As text to be printed.
std::string static_error_lines(const config::Config& config, const std::vector<stages::StaticError>& errors,
                               const std::vector<stages::LoadPlace>& residual);

/// For the summary: a list of {"set", "missing"}, or null where nothing was solved for.
files::Json static_error_summary(const std::vector<stages::StaticError>& errors);

}  // namespace ritz::app
