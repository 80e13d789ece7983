#pragma once

namespace ritz {

/// The answer of all ranks to a yes-no question; `alone`: the other ranks did not take part in time, so that no
/// collective call is possible any more.
enum class Vote { all_yes, some_no, alone };

}  // namespace ritz
