#include "exchange.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/printable.hpp"

namespace ritz::python {
namespace {

/// "(20,)", as NumPy writes it.
std::string shown_shape(const Shape& shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i)
    text += (i == 0 ? "" : ", ") + (shape[i] < 0 ? std::string("any number") : std::to_string(shape[i]));
  return text + (shape.size() == 1 ? ",)" : ")");
}

}  // namespace

py::array view(const py::object& owner, const py::dtype& type, const void* first, const Shape& shape,
               const Shape& strides) {
  py::array array(type, shape, strides, first, owner);
  array.attr("setflags")(false);
  return array;
}

py::array_t<double> handed_over(std::vector<double> numbers, const Shape& shape) {
  auto kept = std::make_unique<std::vector<double>>(std::move(numbers));
  const double* first = kept->data();
  const py::capsule owner(kept.get(), [](void* vector) { delete static_cast<std::vector<double>*>(vector); });
  kept.release();
  return py::array_t<double>(shape, first, owner);
}

Numbers numbers(py::handle given, const char* name, const Shape& shape, const char* meaning) {
  const auto array = Numbers::ensure(given);
  if (!array) throw InputError(std::string(name) + " must be " + meaning + ", and is no array of real numbers");
  const auto fits = [](py::ssize_t is, py::ssize_t wanted) { return wanted < 0 || is == wanted; };
  if (std::equal(array.shape(), array.shape() + array.ndim(), shape.begin(), shape.end(), fits)) return array;
  throw InputError(std::string(name) + " has the shape " + shown_shape({array.shape(), array.shape() + array.ndim()}) +
                   ", and must be " + meaning + ", " + shown_shape(shape));
}

Numbers coordinates(py::handle given, const char* name, Eigen::Index r) {
  return numbers(given, name, {r}, "one number for each reduced coordinate");
}

std::size_t one_of(std::initializer_list<std::string_view> words, std::string_view word, const char* name) {
  const auto* at = std::find(words.begin(), words.end(), word);
  if (at == words.end())
    throw InputError("unknown " + std::string(name) + " '" + printable(word) + "'" + hint(word, words));
  return static_cast<std::size_t>(at - words.begin());
}

void warn(const std::string& text) {
  if (PyErr_WarnEx(PyExc_RuntimeWarning, printable(text).c_str(), 1) != 0) throw py::error_already_set();
}

void Interruptions::look() {
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  const py::gil_scoped_acquire held;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace ritz::python
