// What PETSc's integers cannot count is refused before they wrap.
#include "ritz/algebra/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <new>

#include "ritz/base/error.hpp"

namespace ritz::algebra {
namespace {

constexpr std::int64_t most = std::numeric_limits<PetscInt>::max();

TEST(Check, CountsUpToPetscsLargestInteger) { EXPECT_NO_THROW(refuse_beyond_index("a mesh", most)); }

TEST(Check, RefusesWhatIsBeyond) {
  if (most == std::numeric_limits<std::int64_t>::max()) GTEST_SKIP() << "PETSc has 64-bit indices";
  EXPECT_THAT([] { refuse_beyond_index("the mesh has many degrees of freedom", most + 1); },
              testing::ThrowsMessage<InputError>(
                  testing::AllOf(testing::HasSubstr("the mesh has many degrees of freedom, more than the 2147483647"),
                                 testing::HasSubstr("64-bit indices"))));
}

TEST(Check, NamesALackOfMemoryWhateverPetscsCodeForIt) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer ends a program that asks for so much";
#endif
  keep_messages();
  void* none = nullptr;
  EXPECT_THROW(check(PetscMalloc(std::size_t{1} << 60, &none)), std::bad_alloc);
  EXPECT_THROW(check(PETSC_ERR_MEM), std::bad_alloc);
  EXPECT_THROW(check(PETSC_ERR_SUP), NumericalError);
  PetscPopErrorHandler();
}

}  // namespace
}  // namespace ritz::algebra
