// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "threads/worker_pool.hpp"

#include "threads/process.hpp"

#include <chrono>
#include <thread>

#if defined(__unix__) || defined(__APPLE__)
#include <csignal>
#endif

namespace hg {
namespace {

// How long to look for what is about to happen before going to sleep: some times what waking up costs. A call of the
// library makes several passes, one soon after the other.
constexpr std::chrono::microseconds kPatience{100};
constexpr int kLooks = 64;  // between two looks at the clock

inline void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

template <class Condition>
bool soon(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  do {
    for (int look = 0; look < kLooks; look++) {
      if (condition()) return true;
      pause();
    }
  } while (std::chrono::steady_clock::now() < end);
  return false;
}

// The parts of a desk's state.
constexpr uint64_t kSeat = uint64_t{1} << 32, kTaken = uint64_t{1} << 16, kInside = 1, kCount = 0xffff;
constexpr uint64_t seats(uint64_t state) { return state / kSeat; }
constexpr uint64_t taken(uint64_t state) { return state / kTaken & kCount; }
constexpr uint64_t inside(uint64_t state) { return state & kCount; }

constexpr uint32_t bit_of(int desk) { return uint32_t{1} << desk; }

// Signals of the program are for its own threads.
class SignalsBlocked {
#if defined(__unix__) || defined(__APPLE__)
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked &) = delete;
  SignalsBlocked &operator=(const SignalsBlocked &) = delete;

 private:
  sigset_t before_;
#endif
};

}  // namespace

WorkerPool &WorkerPool::of_process() {
  struct Owner {
    WorkerPool pool;
    long process;
  };
  static std::atomic<Owner *> owner{nullptr};
  const long process = process_id();
  Owner *current = owner.load(std::memory_order_acquire);
  while (current == nullptr || current->process != process) {
    auto *mine = new Owner;
    mine->process = process;
    if (current != nullptr) mine->pool.before_fork_ = &current->pool;
    if (owner.compare_exchange_strong(current, mine)) return mine->pool;
    delete mine;
  }
  return current->pool;
}

void WorkerPool::run(SharedTasks &tasks, int helpers) {
  const int desk = take_desk();
  if (desk < 0) return tasks.work(0);
  open(desk, tasks, helpers);
  tasks.work(0);
  close(desk);
}

int WorkerPool::take_desk() {
  for (int desk = 0; desk < kDesks; desk++) {
    if ((used_.fetch_or(bit_of(desk)) & bit_of(desk)) == 0) return desk;
  }
  return -1;
}

// A machine that has no more threads to give leaves the caller with fewer helpers.
void WorkerPool::hire(int helpers) noexcept {
  if (hired_ >= helpers) return;
  const std::lock_guard<std::mutex> guard(lock_);
  [[maybe_unused]] const SignalsBlocked blocked;
  try {
    for (; hired_ < helpers; hired_++) std::thread([this] { serve(); }).detach();
  } catch (...) {
  }
}

void WorkerPool::open(int desk, SharedTasks &tasks, int helpers) {
  hire(helpers);
  desks_[desk].tasks = &tasks;
  desks_[desk].state = static_cast<uint64_t>(helpers) * kSeat;
  open_ |= bit_of(desk);
  // Whoever joins wakes two more, so the caller gets to work at once.
  wake(helpers < 2 ? helpers : 2);
}

void WorkerPool::close(int desk) {
  desks_[desk].state &= kSeat - 1;
  open_ &= ~bit_of(desk);
  wait_for_helpers(desks_[desk]);
  used_ &= ~bit_of(desk);
}

void WorkerPool::wait_for_helpers(const Desk &desk) {
  const auto alone = [&] { return inside(desk.state) == 0; };
  if (soon(alone)) return;
  std::unique_lock<std::mutex> guard(lock_);
  waiting_++;
  left_.wait(guard, alone);
  waiting_--;
}

void WorkerPool::serve() {
  for (;;) {
    if (!soon([&] { return open_ != 0; })) sleep();
    for (int desk = 0; desk < kDesks; desk++) {
      if ((open_ & bit_of(desk)) == 0) continue;
      const int worker = join(desk);
      if (worker == 0) continue;
      desks_[desk].tasks->work(worker);
      leave(desks_[desk]);
    }
  }
}

// The number of the worker that the thread has become; 0: no seat was free.
int WorkerPool::join(int desk) {
  std::atomic<uint64_t> &state = desks_[desk].state;
  uint64_t now = state;
  while (seats(now) > 0) {
    if (!state.compare_exchange_weak(now, now - kSeat + kTaken + kInside)) continue;
    if (seats(now) == 1) {
      open_ &= ~bit_of(desk);
    } else {
      wake(2);
    }
    return static_cast<int>(taken(now)) + 1;
  }
  return 0;
}

void WorkerPool::leave(Desk &desk) {
  if (inside(desk.state.fetch_sub(kInside)) > 1 || waiting_ == 0) return;
  { const std::lock_guard<std::mutex> guard(lock_); }
  left_.notify_all();
}

void WorkerPool::sleep() {
  std::unique_lock<std::mutex> guard(lock_);
  asleep_++;
  work_.wait(guard, [&] { return open_ != 0; });
  asleep_--;
}

void WorkerPool::wake(int helpers) {
  if (asleep_ == 0) return;
  { const std::lock_guard<std::mutex> guard(lock_); }
  for (int k = 0; k < helpers; k++) work_.notify_one();
}

}  // namespace hg
