// Agreement among the ranks that write one file, through Access::sum and Access::vote.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "ritz/format/writer.hpp"

namespace ritz::format {

/// *Collective*. The sum over the ranks, modulo 2^64.
std::uint64_t sum(const Access& access, std::uint64_t value);
/// *Collective*. The value of the rank with Access::writes_small.
std::uint64_t shared(const Access& access, std::uint64_t value);
/// *Collective*. The same for a text of any length.
std::string shared(const Access& access, std::string bytes);
/// *Collective*. Whether all ranks pass true, as in Access::vote.
Vote vote(const Access& access, bool yes);
/// *Collective*. Throws std::runtime_error on all ranks when `ok`, the success of the last HDF5 call, is false on one
/// of them; only on that one if the other ranks never come.
void agree(const ModelWriter& out, bool ok, const std::string& path);
/// *Collective*. Runs `work` on the rank with Access::writes_small. Its exception is rethrown there, and the other
/// ranks throw std::runtime_error.
void on_writer(const ModelWriter& out, const std::function<void()>& work);

}  // namespace ritz::format
