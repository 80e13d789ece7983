// Registers of 32 bytes as plain values, arrays whose wide loads never straddle two cache lines, and functions that are
// compiled for narrow and wide machines at once.
#pragma once
#include <cstddef>
#include <new>
#include <vector>

// One version for AVX2 with FMA, one for the target of the compiler; the program chooses between them when it starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12
#define RITZ_WIDE __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define RITZ_WIDE
#endif
#define RITZ_INLINE inline __attribute__((always_inline))

namespace ritz {

inline constexpr std::size_t pack_bytes = 32;

/// The number of scalars in a register.
template <class Scalar>
inline constexpr std::ptrdiff_t lanes = static_cast<std::ptrdiff_t>(pack_bytes / sizeof(Scalar));

/// A register, aligned to 32 bytes; it may alias any numbers. On machines without wide registers GCC turns it into
/// pairs of narrow ones.
template <class Scalar>
struct PackOf;
template <>
struct PackOf<double> {
  typedef double type __attribute__((vector_size(32), may_alias));
};
template <>
struct PackOf<float> {
  typedef float type __attribute__((vector_size(32), may_alias));
};
template <class Scalar>
using Pack = typename PackOf<Scalar>::type;

template <class Scalar>
RITZ_INLINE const Pack<Scalar>* packs(const Scalar* p) {
  return reinterpret_cast<const Pack<Scalar>*>(p);
}
template <class Scalar>
RITZ_INLINE Pack<Scalar>* packs(Scalar* p) {
  return reinterpret_cast<Pack<Scalar>*>(p);
}

inline constexpr std::size_t cache_line = 64;  ///< bytes

/// An allocator whose memory begins on a cache line.
template <class T>
struct LineAllocator {
  using value_type = T;

  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}

  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(cache_line))); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(cache_line)); }
  bool operator==(const LineAllocator&) const { return true; }
};

/// A std::vector whose first element is at the start of a cache line.
template <class T>
using AlignedVector = std::vector<T, LineAllocator<T>>;

}  // namespace ritz
