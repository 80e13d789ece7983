// A fuzz target: what a program of ours does with a file that a stranger made.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace ritz::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// The target itself, defined once in each executable: reads `input` as a program would. Returns, or throws InputError.
void read_input(Bytes input);

/// Runs the target; what it said of an input that it refused, else nothing. Everything else is a finding, which is told
/// on stderr and ends the process by abort: another exception, a refusal without a message, `finding`.
std::string outcome(Bytes input);

/// Ends the process by abort, `what` on stderr.
[[noreturn]] void finding(const std::string& what);

/// `input` as a file with the given name, in a folder of this process in memory. The same path each time.
std::filesystem::path as_file(Bytes input, const std::string& name);

}  // namespace ritz::fuzz
