// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Threads that help. Whoever calls works itself, taking task after task; helpers that are awake join in. Nobody waits
// for a helper that has not come: on cores that are busy otherwise a call takes what it takes on one thread.
#pragma once

#include "threads/shared_tasks.hpp"

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace hg {

// Any thread may call; several at once share the helpers.
class WorkerPool {
 public:
  // The pool of this process; a forked child gets one of its own. Never destroyed: helpers sleep until the process
  // ends.
  static WorkerPool &of_process();

  // Returns when all tasks have been done, by the calling thread and at most `helpers` others.
  void run(SharedTasks &tasks, int helpers);

 private:
  // Where the helpers of one call meet. Owned by the pool, so that who comes late finds it closed, not gone.
  struct alignas(64) Desk {
    std::atomic<uint64_t> state{0};  // how many seats are free, have been taken, are occupied now
    SharedTasks *tasks = nullptr;    // of those who have a seat
  };
  static constexpr int kDesks = 16;  // calls at the same time that get helpers; others work alone

  int take_desk();
  void hire(int helpers) noexcept;
  void open(int desk, SharedTasks &tasks, int helpers);
  void close(int desk);
  void wait_for_helpers(const Desk &desk);

  void serve();
  int join(int desk);
  void leave(Desk &desk);
  void sleep();
  void wake(int helpers);

  Desk desks_[kDesks];
  alignas(64) std::atomic<uint32_t> open_{0};  // a bit for each desk with free seats
  alignas(64) std::atomic<uint32_t> used_{0};  // and for each that belongs to a call
  std::atomic<int> asleep_{0}, waiting_{0};    // helpers; callers that sleep until their helpers have left
  std::mutex lock_;                            // of those who go to sleep
  std::condition_variable work_, left_;
  std::atomic<int> hired_{0};
  WorkerPool *before_fork_ = nullptr;  // kept reachable, so that no tool takes it for lost
};

}  // namespace hg
