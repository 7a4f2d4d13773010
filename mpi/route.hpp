// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which rows go to which rank, and rows of any size sent so, or back. Ghosts and migrating particles take the same way.
#pragma once

#include "mpi/agreement.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

namespace hgrid::mpi {

class Route {
 public:
  explicit Route(MPI_Comm comm) : comm_(comm) {}

  // rows[k]: those for rank k, of `count` rows that this rank has. Collective.
  void plan(size_t count, const std::vector<std::vector<int32_t>> &rows);

  size_t source_count() const { return source_count_; }
  size_t arrival_count() const { return receive_begin_.empty() ? 0 : receive_begin_.back(); }
  // Ranks that rows go to or come from, this one left out.
  int64_t send_rank_count() const { return others(send_begin_); }
  int64_t receive_rank_count() const { return others(receive_begin_); }
  // The rank that sends the k-th row to arrive; rows come rank by rank.
  int32_t source_of(size_t arrival) const;
  // Bytes that went to other ranks.
  int64_t sent_byte_count() const { return sent_byte_count_; }

  // Sends what pack(row) makes of each row that goes anywhere. Collective.
  template <class Packed, class Pack>
  std::vector<Packed> send(Pack &&pack) {
    std::vector<Packed> arriving;
    together(comm_, [&] {
      buffer_.resize(rows_.size() * sizeof(Packed));
      for (size_t k = 0; k < rows_.size(); k++) {
        const Packed packed = pack(static_cast<size_t>(rows_[k]));
        std::memcpy(buffer_.data() + k * sizeof packed, &packed, sizeof packed);
      }
      arriving.resize(arrival_count());
    });
    exchange(sizeof(Packed), buffer_.data(), send_begin_, reinterpret_cast<char *>(arriving.data()), receive_begin_);
    return arriving;
  }
  // Collective; row_bytes is the same on all ranks, which is checked, after what else must hold on all.
  // from: [source_count()], to: [arrival_count()].
  void forward(size_t row_bytes, const void *from, void *to, const std::function<void()> &check);
  // The other way: to[row] += what the ranks that got the row have, by ascending rank.
  void add_back(size_t columns, const double *from, double *to, const std::function<void()> &check);

 private:
  int64_t others(const std::vector<size_t> &begin) const;
  // Sends slices of `out` and receives slices of `in`, both cut as the vectors say, in rows of row_bytes.
  void exchange(size_t row_bytes, const char *out, const std::vector<size_t> &out_begin, char *in,
                const std::vector<size_t> &in_begin);

  MPI_Comm comm_;
  int rank_ = 0;
  size_t source_count_ = 0;
  std::vector<int32_t> rows_;                       // to send, rank by rank
  std::vector<size_t> send_begin_, receive_begin_;  // [ranks + 1]
  std::vector<MPI_Request> requests_;
  std::vector<char> buffer_;
  int64_t sent_byte_count_ = 0;
};

}  // namespace hgrid::mpi
