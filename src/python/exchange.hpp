// What is exchanged with Python: NumPy arrays as views of the numbers of a model, as results and as arguments; words,
// and warnings.
#pragma once
#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <chrono>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/model/model.hpp"

namespace ritz::python {

namespace py = pybind11;

using Shape = std::vector<py::ssize_t>;

/// A read-only array, without a copy, of numbers that `owner` holds and keeps. It keeps the owner alive. NumPy refuses
/// to make it writable, as the owner is no buffer.
py::array view(const py::object& owner, const py::dtype& type, const void* first, const Shape& shape,
               const Shape& strides);

/// The same of a whole vector, of one dimension.
template <class Number>
py::array view(const py::object& owner, const std::vector<Number>& numbers) {
  return view(owner, py::dtype::of<Number>(), numbers.data(), {std::ssize(numbers)}, {sizeof(Number)});
}

/// The same of flags that are 0 or 1, as an array of bool.
template <class Flag>
py::array view_flags(const py::object& owner, const std::vector<Flag>& flags) {
  static_assert(sizeof(Flag) == sizeof(bool));
  return view(owner, py::dtype::of<bool>(), flags.data(), {std::ssize(flags)}, {sizeof(Flag)});
}

/// The same of a vector (n) or matrix (rows, columns), in the order in which Eigen stores it.
template <class Plain>
py::array view(const py::object& owner, const Eigen::PlainObjectBase<Plain>& numbers) {
  constexpr py::ssize_t size = sizeof(double);
  const auto type = py::dtype::of<double>();
  if constexpr (Plain::IsVectorAtCompileTime) return view(owner, type, numbers.data(), {numbers.size()}, {size});
  else
    return view(owner, type, numbers.data(), {numbers.rows(), numbers.cols()},
                {size * numbers.rowStride(), size * numbers.colStride()});
}

/// A new array: the numbers of a vector (n) or of a matrix (rows, columns).
template <class Derived>
py::array_t<double> copied(const Eigen::DenseBase<Derived>& numbers) {
  if constexpr (Derived::IsVectorAtCompileTime) {
    py::array_t<double> array(numbers.size());
    Eigen::Map<Eigen::VectorXd>(array.mutable_data(), numbers.size()) = numbers.derived();
    return array;
  } else {
    py::array_t<double> array(Shape{numbers.rows(), numbers.cols()});
    Eigen::Map<model::RowMatrix>(array.mutable_data(), numbers.rows(), numbers.cols()) = numbers.derived();
    return array;
  }
}

/// A new array that takes over the numbers, without a copy.
py::array_t<double> handed_over(std::vector<double> numbers, const Shape& shape);

/// An argument: numbers of 64 bits in C order.
using Numbers = py::array_t<double, int(py::array::c_style) | int(py::detail::npy_api::NPY_ARRAY_ALIGNED_)>;

/// `given` as such numbers: itself, or a copy where it is of another kind that fits without loss (a list, float32,
/// whole numbers). Throws InputError, in which `name` stands for the argument and `meaning` says what it must be, when
/// it has no such numbers or another shape than `shape`, in which -1 stands for any number.
Numbers numbers(py::handle given, const char* name, const Shape& shape, const char* meaning);

/// r numbers, one for each reduced coordinate.
Numbers coordinates(py::handle given, const char* name, Eigen::Index r);

/// The numbers of a one-dimensional argument.
inline Eigen::Map<const Eigen::VectorXd> vector(const Numbers& numbers) { return {numbers.data(), numbers.size()}; }

/// The index of `word` among `words`, of which the argument `name` must be one. Throws InputError that names the
/// nearest one.
std::size_t one_of(std::initializer_list<std::string_view> words, std::string_view word, const char* name);

/// Warns as Python programs do: RuntimeWarning.
void warn(const std::string& text);

/// For long work without the interpreter's lock: throws what Python's signal handlers raise, such as KeyboardInterrupt
/// after Ctrl-C. Looks ten times a second.
class Interruptions {
 public:
  void look();

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_ = Clock::now();
};

}  // namespace ritz::python
