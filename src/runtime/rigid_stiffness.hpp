// What tells the rounding of a rigid motion's stiffness from that of a soft mode.
#pragma once

namespace ritz::runtime {

/// A diagonal entry of K̃(0) below this fraction of the largest counts as 0.
inline constexpr double rigid_stiffness = 1e-10;

}  // namespace ritz::runtime
