#include "ritz/files/failure.hpp"

#include <cerrno>
#include <system_error>

#include "ritz/base/error.hpp"

namespace ritz::files {
namespace {

/// Whether another name or another folder is what helps.
bool is_of_the_name(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
    case EISDIR:
    case EACCES:
    case EPERM:
    case EROFS:
    case ENAMETOOLONG:
    case ELOOP:
    case EINVAL: return true;
    default: return false;
  }
}

}  // namespace

std::string why(int error) {
  switch (error) {
    case 0: return "is the disk full?";
    case ENOSPC: return "the disk is full";
    case EDQUOT: return "the disk quota is used up";
    case EFBIG: return "the file would be longer than the limit of this process (ulimit -f) or of the file system";
    case EROFS: return "the file system is read-only";
    case EACCES:
    case EPERM: return "permission is denied";
    case ENAMETOOLONG: return "the name is too long";
    case EMFILE:
    case ENFILE: return "too many files are open (ulimit -n)";
    case EIO: return "the disk reports an error";
    case ENOENT: return "there is no such folder, or it takes no files";
    case ENOTDIR: return "a part of the path is no folder";
    case EISDIR: return "it is a folder";
    case ELOOP: return "too many symbolic links are on the way";
    default: return std::generic_category().message(error);
  }
}

void fail_to_write(const std::string& what, int error) {
  const std::string said = "cannot write " + what + ": " + why(error);
  if (is_of_the_name(error)) throw InputError(said + "; choose a name in a folder that exists and can be written to");
  const bool room = error == 0 || error == ENOSPC || error == EDQUOT;
  throw NumericalError(said + (room ? "; make room and run again" : "; mend that and run again"));
}

}  // namespace ritz::files
