#include "ritz/parallel/redistribute.hpp"

#include <algorithm>

namespace ritz::parallel {
namespace {

std::int64_t slice_start(int ranks, std::int64_t total, std::int64_t rank) { return total * rank / ranks; }

template <class T>
struct Rows {
  std::vector<std::int64_t> numbers;
  std::vector<T> values;
};

/// Moves rows of `width` values to the ranks whose even slices hold their numbers; in ascending order of numbers.
template <class T>
Rows<T> move_rows(MPI_Comm comm, std::span<const std::int64_t> numbers, std::span<const T> values, int width,
                  std::int64_t total) {
  const int ranks = size(comm);
  const auto w = static_cast<std::ptrdiff_t>(width);
  std::vector<std::vector<std::int64_t>> where(static_cast<std::size_t>(ranks));
  std::vector<std::vector<T>> what(where.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto p = static_cast<std::size_t>(slice_owner(ranks, total, numbers[i]));
    const auto row = values.begin() + static_cast<std::ptrdiff_t>(i) * w;
    where[p].push_back(numbers[i]);
    what[p].insert(what[p].end(), row, row + w);
  }
  where = exchange(comm, where);
  what = exchange(comm, what);
  std::vector<std::pair<std::int64_t, const T*>> order;
  for (std::size_t p = 0; p < where.size(); ++p)
    for (std::size_t i = 0; i < where[p].size(); ++i)
      order.emplace_back(where[p][i], what[p].data() + static_cast<std::ptrdiff_t>(i) * w);
  std::sort(order.begin(), order.end());
  Rows<T> rows;
  rows.values.reserve(order.size() * static_cast<std::size_t>(width));
  for (const auto& [number, row] : order) {
    rows.numbers.push_back(number);
    rows.values.insert(rows.values.end(), row, row + w);
  }
  return rows;
}

}  // namespace

Slice even_slice(MPI_Comm comm, std::int64_t total) {
  const int p = rank(comm), ranks = size(comm);
  const auto first = slice_start(ranks, total, p);
  return {first, slice_start(ranks, total, p + 1) - first, total};
}

int slice_owner(int ranks, std::int64_t total, std::int64_t row) {
  auto p = static_cast<int>(row * ranks / total);
  while (slice_start(ranks, total, p + 1) <= row) ++p;
  while (slice_start(ranks, total, p) > row) --p;
  return p;
}

RowMatrix to_slices(MPI_Comm comm, std::span<const std::int64_t> numbers, const RowMatrix& values, std::int64_t total) {
  const auto width = static_cast<int>(values.cols());
  const auto rows =
      move_rows<double>(comm, numbers, {values.data(), static_cast<std::size_t>(values.size())}, width, total);
  return Eigen::Map<const RowMatrix>(rows.values.data(), static_cast<Eigen::Index>(rows.numbers.size()), width);
}

RowMatrix from_slices(MPI_Comm comm, std::span<const std::int64_t> numbers, const RowMatrix& slice,
                      std::int64_t total) {
  const auto ranks = static_cast<std::size_t>(size(comm));
  const auto width = slice.cols();
  const auto first = even_slice(comm, total).first;
  std::vector<std::vector<std::int64_t>> asked(ranks);
  for (const auto number : numbers)
    asked[static_cast<std::size_t>(slice_owner(size(comm), total, number))].push_back(number);
  const auto wanted = exchange(comm, asked);
  std::vector<std::vector<double>> answers(ranks);
  for (std::size_t p = 0; p < ranks; ++p)
    for (const auto number : wanted[p])
      answers[p].insert(answers[p].end(), slice.row(number - first).begin(), slice.row(number - first).end());
  answers = exchange(comm, answers);
  RowMatrix rows(static_cast<Eigen::Index>(numbers.size()), width);
  std::vector<const double*> next;
  for (const auto& answer : answers) next.push_back(answer.data());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const double*& from =
        next[static_cast<std::size_t>(slice_owner(size(comm), total, numbers[static_cast<std::size_t>(i)]))];
    rows.row(i) = Eigen::Map<const Eigen::RowVectorXd>(from, width);
    from += width;
  }
  return rows;
}

std::vector<std::int64_t> sorted_by_key(MPI_Comm comm, std::span<const std::int64_t> row_keys,
                                        std::span<const std::int64_t> values, int width, std::int64_t keys) {
  return move_rows<std::int64_t>(comm, row_keys, values, width, keys).values;
}

}  // namespace ritz::parallel
