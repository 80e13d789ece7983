#include "ritz/format/parallel_access.hpp"

#ifdef H5_HAVE_PARALLEL
namespace ritz::format {

ParallelLists::ParallelLists(MPI_Comm comm) : file(H5Pcreate(H5P_FILE_ACCESS)), transfer(H5Pcreate(H5P_DATASET_XFER)) {
  H5Pset_fapl_mpio(file.get(), comm, MPI_INFO_NULL);
  H5Pset_dxpl_mpio(transfer.get(), H5FD_MPIO_COLLECTIVE);
}

}  // namespace ritz::format
#endif
