// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/route.hpp"

#include <algorithm>
#include <climits>
#include <cstring>

namespace hgrid::mpi {
namespace {

constexpr int kTag = 1;

// Counts of MPI are int; those of rows are below 2^31, those of bytes need not be.
class RowType {
 public:
  explicit RowType(size_t row_bytes) {
    check_mpi(MPI_Type_contiguous(static_cast<int>(row_bytes), MPI_BYTE, &type_), "MPI_Type_contiguous");
    check_mpi(MPI_Type_commit(&type_), "MPI_Type_commit");
  }
  ~RowType() { MPI_Type_free(&type_); }
  RowType(const RowType &) = delete;
  RowType &operator=(const RowType &) = delete;
  MPI_Datatype get() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

std::vector<size_t> sums_of(const std::vector<int> &counts) {
  std::vector<size_t> begin(1, 0);
  begin.reserve(counts.size() + 1);
  for (const int count : counts) begin.push_back(begin.back() + static_cast<size_t>(count));
  return begin;
}

}  // namespace

void Route::plan(size_t count, const std::vector<std::vector<int32_t>> &rows) {
  std::vector<int> outgoing, incoming;
  together(comm_, [&] {
    for (const std::vector<int32_t> &list : rows) outgoing.push_back(static_cast<int>(list.size()));
    incoming.resize(rows.size());
    rows_.clear();
    for (const std::vector<int32_t> &list : rows) rows_.insert(rows_.end(), list.begin(), list.end());
  });
  source_count_ = count;
  check_mpi(MPI_Comm_rank(comm_, &rank_), "MPI_Comm_rank");
  check_mpi(MPI_Alltoall(outgoing.data(), 1, MPI_INT, incoming.data(), 1, MPI_INT, comm_), "MPI_Alltoall");
  together(comm_, [&] {
    send_begin_ = sums_of(outgoing);
    receive_begin_ = sums_of(incoming);
    if (receive_begin_.back() > INT32_MAX - count) {
      fail(HG_ERR_LIMIT, "%zu rows to receive beside %zu: more than 2^31 - 1", receive_begin_.back(), count);
    }
    requests_.resize(2 * rows.size());
  });
}

int64_t Route::others(const std::vector<size_t> &begin) const {
  int64_t count = 0;
  for (size_t k = 0; k + 1 < begin.size(); k++) {
    if (begin[k] < begin[k + 1] && k != static_cast<size_t>(rank_)) count++;
  }
  return count;
}

int32_t Route::source_of(size_t arrival) const {
  const auto next = std::upper_bound(receive_begin_.begin(), receive_begin_.end(), arrival);
  return static_cast<int32_t>(next - receive_begin_.begin()) - 1;
}

void Route::exchange(size_t row_bytes, const char *out, const std::vector<size_t> &out_begin, char *in,
                     const std::vector<size_t> &in_begin) {
  const RowType row(row_bytes);
  int used = 0;
  for (size_t k = 0; k + 1 < in_begin.size(); k++) {
    const size_t count = in_begin[k + 1] - in_begin[k];
    if (count == 0) continue;
    check_mpi(MPI_Irecv(in + in_begin[k] * row_bytes, static_cast<int>(count), row.get(), static_cast<int>(k), kTag,
                        comm_, &requests_[static_cast<size_t>(used++)]),
              "MPI_Irecv");
  }
  for (size_t k = 0; k + 1 < out_begin.size(); k++) {
    const size_t count = out_begin[k + 1] - out_begin[k];
    if (count == 0) continue;
    check_mpi(MPI_Isend(out + out_begin[k] * row_bytes, static_cast<int>(count), row.get(), static_cast<int>(k), kTag,
                        comm_, &requests_[static_cast<size_t>(used++)]),
              "MPI_Isend");
    if (k != static_cast<size_t>(rank_)) sent_byte_count_ += static_cast<int64_t>(count * row_bytes);
  }
  check_mpi(MPI_Waitall(used, requests_.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
}

void Route::forward(size_t row_bytes, const void *from, void *to, const std::function<void()> &check) {
  together_of(comm_, static_cast<int64_t>(row_bytes), "row_bytes", [&] {
    check();
    if (row_bytes > INT_MAX) fail(HG_ERR_ARGUMENT, "row_bytes = %zu is above 2^31 - 1", row_bytes);
    if (source_count_ > 0 && row_bytes > 0) check_pointer(from, "the rows to send");
    if (arrival_count() > 0 && row_bytes > 0) check_pointer(to, "the rows to receive");
    buffer_.resize(rows_.size() * row_bytes);
    const auto *rows = static_cast<const char *>(from);
    for (size_t k = 0; k < rows_.size() && row_bytes > 0; k++) {
      std::memcpy(buffer_.data() + k * row_bytes, rows + static_cast<size_t>(rows_[k]) * row_bytes, row_bytes);
    }
  });
  if (row_bytes > 0) exchange(row_bytes, buffer_.data(), send_begin_, static_cast<char *>(to), receive_begin_);
}

void Route::add_back(size_t columns, const double *from, double *to, const std::function<void()> &check) {
  const size_t row_bytes = columns * sizeof(double);
  together_of(comm_, static_cast<int64_t>(columns), "columns", [&] {
    check();
    if (columns > INT_MAX / sizeof(double)) fail(HG_ERR_ARGUMENT, "columns = %zu are above 2^28 - 1", columns);
    if (arrival_count() > 0 && columns > 0) check_pointer(from, "ghosts");
    if (source_count_ > 0 && columns > 0) check_pointer(to, "owned");
    buffer_.resize(rows_.size() * row_bytes);
  });
  if (columns == 0) return;
  exchange(row_bytes, reinterpret_cast<const char *>(from), receive_begin_, buffer_.data(), send_begin_);
  for (size_t k = 0; k < rows_.size(); k++) {
    double *sum = to + static_cast<size_t>(rows_[k]) * columns;
    for (size_t column = 0; column < columns; column++) {
      double term = 0;
      std::memcpy(&term, buffer_.data() + (k * columns + column) * sizeof term, sizeof term);
      sum[column] += term;
    }
  }
}

}  // namespace hgrid::mpi
