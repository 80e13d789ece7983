// One file written by all ranks together. Only where HDF5 itself was built for MPI; empty elsewhere.
#pragma once
#include "ritz/format/handle.hpp"

#ifdef H5_HAVE_PARALLEL
namespace ritz::format {

/// The two property lists of Access for the ranks of a communicator. They must outlive the writer.
struct ParallelLists {
  Properties file;      ///< the file is opened by all ranks
  Properties transfer;  ///< datasets are written by all ranks in one call

  explicit ParallelLists(MPI_Comm comm);
};

}  // namespace ritz::format
#endif
