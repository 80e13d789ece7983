// Writing one file by all ranks together. Only where HDF5 was built with MPI; empty otherwise.
#pragma once
#include "ritz/format/handle.hpp"

#ifdef H5_HAVE_PARALLEL
namespace ritz::format {

/// The two property lists of Access for the ranks of `comm`. They must outlive the writer.
struct ParallelLists {
  Properties file;      ///< of the file, which all ranks open
  Properties transfer;  ///< of the datasets, which all ranks write in one collective call

  explicit ParallelLists(MPI_Comm comm);
};

}  // namespace ritz::format
#endif
