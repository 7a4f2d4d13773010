// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The ranks that share a simulation, and how they agree: what goes wrong on one ends all, with a text that names it.
#pragma once

#include "particles/error.hpp"

#include <mpi.h>

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace dem::ranks {

class Ranks {
 public:
  // Borrows the communicator.
  explicit Ranks(MPI_Comm comm);

  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_first() const { return rank_ == 0; }

  // All below are collective.

  bool all(bool mine) const;
  bool any(bool mine) const { return !all(!mine); }
  int64_t largest(int64_t mine) const;
  double largest(double mine) const;

  // Each of the numbers becomes the sum over all ranks.
  void add_up(std::vector<int64_t> &numbers) const;

  // What the first rank has.
  template <class T>
  T of_first(T value) const {
    static_assert(std::is_trivially_copyable_v<T>, "it travels as bytes");
    MPI_Bcast(&value, sizeof value, MPI_BYTE, 0, comm_);
    return value;
  }

  // Runs `body`, which calls no MPI. If it throws on any rank, all throw Error: the text of the lowest of these, with
  // its number unless all say the same.
  template <class Body>
  void together(Body &&body) const {
    std::optional<std::string> fault;
    try {
      body();
    } catch (const std::exception &error) {
      fault = particles::message_of(error);
    }
    agree(fault);
  }

 private:
  void agree(const std::optional<std::string> &fault) const;

  MPI_Comm comm_;
  int rank_ = 0, size_ = 1;
};

}  // namespace dem::ranks
