// What a user of ritz-reduce and ritz-full can do when the method fails, in terms of their options.
#pragma once
#include <functional>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/config/config.hpp"

namespace ritz::config {

/// The error's message, preceded by the option that it is about and followed by the options that help.
std::string advised(const Error& error, const Config& config);

/// The work of a program with its options.
using Work = std::function<void(MPI_Comm comm, const Config& config)>;

/// The same work, whose InputErrors and NumericalErrors are rethrown with the advised message.
Work with_advice(Work work);

}  // namespace ritz::config
