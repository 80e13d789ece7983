#pragma once

namespace ritz {

/// What all ranks said to a question; or that the others are elsewhere, so that nothing collective works any more.
enum class Vote { all_yes, some_no, alone };

}  // namespace ritz
