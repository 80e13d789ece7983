// What a user of ritz-reduce and ritz-full can do where the method failed: in the words of their options.
#pragma once
#include <functional>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/config/config.hpp"

namespace ritz::config {

/// The error's message with the option that it is about before it, and behind it the options that help.
std::string advised(const Error& error, const Config& config);

/// What a program does with its options.
using Work = std::function<void(MPI_Comm comm, const Config& config)>;

/// The same work, of which an InputError or a NumericalError goes on with its message so advised.
Work with_advice(Work work);

}  // namespace ritz::config
