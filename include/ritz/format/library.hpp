// How a program that reads or writes files begins.
#pragma once

namespace ritz::format {

/// To be called once, before anything else of this layer. From then on the library underneath prints no error of its
/// own, since every error is thrown with one sentence, and does nothing when the process ends, where it would crash
/// after a damaged file or a full disk.
void silence_library();

}  // namespace ritz::format
