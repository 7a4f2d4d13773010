// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The tasks of one loop: whoever is free takes the next one.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>

namespace hg {

class SharedTasks {
 public:
  // Runs one task on one of the workers 0, 1, ... May throw.
  using Run = void (*)(void *body, size_t task, int worker);

  SharedTasks(size_t count, Run run, void *body) : count_(count), run_(run), body_(body) {}

  // Takes tasks until none is left or one has failed.
  void work(int worker) noexcept {
    while (failed_.load(std::memory_order_relaxed) == 0) {
      const size_t task = next_.fetch_add(1, std::memory_order_relaxed);
      if (task >= count_) return;
      try {
        run_(body_, task, worker);
      } catch (...) {
        if (failed_.exchange(1) == 0) failure_ = std::current_exception();
      }
    }
  }

  size_t count() const { return count_; }

  // After everybody has stopped: passes the first failure on.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  size_t count_;
  Run run_;
  void *body_;
  std::atomic<size_t> next_{0};
  std::atomic<int> failed_{0};  // a word: to exchange a byte, gcc 12 calls libatomic on riscv64
  std::exception_ptr failure_;
};

}  // namespace hg
