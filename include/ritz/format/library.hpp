// Initialisation of a program that reads or writes files.
#pragma once

namespace ritz::format {

/// Call this once, before anything else of this layer. From then on HDF5 prints no errors of its own (every error is
/// thrown as an exception with one sentence) and does nothing at the end of the process, where it would crash after a
/// damaged file or a full disk.
void silence_library();

/// The first of these alone, in the calling thread: for a library in a process where others use HDF5, too, and count on
/// what it does at the end.
void silence_errors();

}  // namespace ritz::format
