// What the ranks that write one file must agree on, through Access::sum and Access::vote.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "ritz/format/writer.hpp"

namespace ritz::format {

/// *Collective*: the sum over ranks, modulo 2^64.
std::uint64_t sum(const Access& access, std::uint64_t value);
/// *Collective*: the value of the rank that writes what is small.
std::uint64_t shared(const Access& access, std::uint64_t value);
/// *Collective*: the same for bytes of any number.
std::string shared(const Access& access, std::string bytes);
/// *Collective*: whether all ranks say yes, as Access::vote has it.
Vote vote(const Access& access, bool yes);
/// *Collective*: throws std::runtime_error on all ranks when `ok`, the outcome of HDF5's last call, is false on one;
/// where that one's others never come, on it alone.
void agree(const ModelWriter& out, bool ok, const std::string& path);
/// *Collective*: runs `work` on the rank that writes what is small. What it throws is thrown there, std::runtime_error
/// on the others.
void on_writer(const ModelWriter& out, const std::function<void()>& work);

}  // namespace ritz::format
