// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The conversation between the measuring process and the contestants' processes.
#include "programs/bench/rounds.hpp"

#include "programs/bench/child.hpp"
#include "programs/bench/complaints.hpp"
#include "programs/bench/pair_sets.hpp"

#include <sys/resource.h>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>

namespace bench {
namespace {

enum class Order : char { kRun, kSendPairs, kEnd };

struct Report {
  double seconds = 0;
  size_t pairs = 0;
  double peak_bytes = 0;
  Details details;
};

// A child that finds free but present memory in the heap it inherits would seem to need less than it does.
void release_unused_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void limit_memory(double gibibytes) {
  if (!(gibibytes > 0)) return;
  const auto bytes = static_cast<rlim_t>(gibibytes * 1073741824.0);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_DATA, &limit);
}

// What a contestant's process does until it is told to end.
void serve(const Contestant &contestant, const particles::ParticleSet &particles, double memory, Channel &channel) {
  if (!contestant.isa.empty()) setenv("HGRID_ISA", contestant.isa.c_str(), 1);
  limit_memory(memory);
  const double bytes_before = peak_bytes();
  const Search search = contestant.prepare(particles);
  channel.send(static_cast<bool>(search.run));
  if (!search.run) return;
  PairView pairs;
  for (;;) {
    switch (channel.receive<Order>()) {
      case Order::kRun: {
        Report report;
        report.seconds = search.run(pairs);
        report.pairs = pairs.size();
        report.peak_bytes = peak_bytes() - bytes_before;
        if (search.details) report.details = search.details();
        channel.send(report);
        break;
      }
      case Order::kSendPairs:
        channel.send_array(sorted(pairs.data(), pairs.size()));
        break;
      case Order::kEnd:
        return;
    }
  }
}

// Threads that have just met at the end of a parallel region spin for some milliseconds before they sleep; the next
// contestant shall not pay for that.
void let_threads_settle(const Contestant &contestant) {
  if (contestant.threads != 1) std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

class Runner {
 public:
  Runner(const Entry &entry, const Effort &effort) : effort_(&effort), reference_(entry.reference) {
    result_.contestant = entry.contestant;
    result_.particles = entry.particles;
    release_unused_memory();
    child_ = std::make_unique<Child>(entry.contestant.name + " " + entry.contestant.variant, [&](Channel &channel) {
      complaints_.take();
      serve(entry.contestant, *entry.particles, effort.memory, channel);
    });
    child_->channel().set_patience(effort.patience);
  }

  // Runs and checks the pairs. False if the contestant has nothing to do with these particles.
  bool run_first() {
    bool suited = true;
    guarded([&] {
      suited = child_->channel().receive<bool>();
      if (!suited) return;
      const Report report = run();
      first_ = report.seconds;
      result_.peak_bytes = report.peak_bytes;
      child_->channel().send(Order::kSendPairs);
      result_.fault = reference_->fault(result_.contestant.accuracy, child_->channel().receive_array<hg_pair>());
    });
    if (first_ >= effort_->seconds) {
      result_.seconds.push_back(first_);
      end();
    } else if (suited && result_.contestant.tuned) {
      run_again();  // the choice between variants shall not hang on how the first run got its memory
    }
    return suited;
  }
  void run_again() {
    if (!child_ || spent_ >= effort_->seconds) return;
    guarded([&] {
      result_.seconds.push_back(run().seconds);
      spent_ += result_.seconds.back();
    });
  }
  // Ends the process; what was measured stays.
  void end() {
    if (!child_) return;
    child_->channel().send(Order::kEnd);
    child_->wait();
    child_.reset();
  }
  void lose() {
    end();
    result_.chosen = false;
  }

  double fastest() const { return *std::min_element(result_.seconds.begin(), result_.seconds.end()); }
  const Result &result() const { return result_; }

 private:
  Report run() {
    child_->channel().send(Order::kRun);
    const auto report = child_->channel().receive<Report>();
    result_.details = report.details;
    result_.pairs = report.pairs;
    let_threads_settle(result_.contestant);
    return report;
  }
  template <class Talk>
  void guarded(Talk talk) {
    try {
      talk();
    } catch (const PatienceEnded &ended) {
      result_.gave_up = true;
      result_.fault = ended.what();
      child_.reset();
    } catch (const ProcessEnded &) {
      result_.broke_down = true;
      result_.fault = "broke down: " + child_->wait() + complaints_.reason();
      child_.reset();
    }
  }

  const Effort *effort_;
  const Reference *reference_;
  Complaints complaints_;
  Result result_;
  std::unique_ptr<Child> child_;
  double first_ = 0, spent_ = 0;
};

using Runners = std::vector<std::unique_ptr<Runner>>;

// Of the variants of one name only the fastest goes on. One that did not come to an end, as some settings do not suit
// some sizes, loses against any that did; one with wrong pairs stays, to be seen.
void drop_slower_variants(Runners &runners) {
  for (const auto &runner : runners) {
    const Result &own = runner->result();
    if (!own.contestant.tuned || !own.chosen || (!own.fault.empty() && !own.gave_up && !own.broke_down)) continue;
    const bool beaten = std::any_of(runners.begin(), runners.end(), [&](const auto &other) {
      const Result &rival = other->result();
      return rival.contestant.name == own.contestant.name && rival.chosen && rival.fault.empty() &&
             (!own.fault.empty() || other->fastest() < runner->fastest());
    });
    if (beaten) runner->lose();
  }
}

}  // namespace

std::vector<Result> run_rounds(const std::vector<Entry> &entries, const Effort &effort) {
  Runners runners;
  for (const Entry &entry : entries) {
    runners.push_back(std::make_unique<Runner>(entry, effort));
    if (!runners.back()->run_first()) runners.pop_back();
    drop_slower_variants(runners);  // at once: their memory may be needed
  }
  for (int round = 0; round < effort.repeats; round++) {
    // There and back, so that nobody always follows the same neighbour.
    for (const auto &runner : runners) {
      if (static_cast<int>(runner->result().seconds.size()) <= round) runner->run_again();
    }
    std::reverse(runners.begin(), runners.end());
  }
  if (effort.repeats % 2 == 1) std::reverse(runners.begin(), runners.end());
  std::vector<Result> results;
  for (const auto &runner : runners) {
    runner->end();
    results.push_back(runner->result());
  }
  return results;
}

}  // namespace bench
