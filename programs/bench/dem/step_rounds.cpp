// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The conversation between the measuring process and the contestants' processes.
#include "programs/bench/dem/step_rounds.hpp"

#include "programs/bench/child.hpp"
#include "programs/measure/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <thread>

namespace bench {
namespace {

enum class Order : char { kRun, kSendState, kSendDetails, kEnd };

// Sums of forces come in different orders, and a few steps cannot make much of that.
constexpr double kSameMotion = 1e-9;  // of the smallest radius

void serve(const StepContestant &contestant, const dem::Setup &setup, Channel &channel) {
  if (!contestant.isa.empty()) setenv("HGRID_ISA", contestant.isa.c_str(), 1);
  const Stepper stepper = contestant.prepare(setup);
  channel.send(static_cast<bool>(stepper.run));
  if (!stepper.run) return;
  for (;;) {
    switch (channel.receive<Order>()) {
      case Order::kRun: {
        const auto steps = channel.receive<uint64_t>();
        channel.send(measure::seconds_of([&] { stepper.run(steps); }));
        break;
      }
      case Order::kSendState: {
        const MotionState state = stepper.state();
        channel.send_array(state.centers);
        channel.send_array(state.velocities);
        break;
      }
      case Order::kSendDetails:
        channel.send(stepper.details());
        break;
      case Order::kEnd:
        return;
    }
  }
}

double largest_difference(const std::vector<double> &a, const std::vector<double> &b) {
  double largest = 0;
  // Not std::max: a centre that is no number counts as the largest difference of all.
  for (size_t k = 0; k < a.size(); k++) {
    const double difference = std::abs(a[k] - b[k]);
    if (!(difference <= largest)) largest = difference;
  }
  return largest;
}

class StepRunner {
 public:
  StepRunner(const StepContestant &contestant, const SettledSystem &system, const StepEffort &effort)
      : system_(&system), effort_(&effort) {
    result_.contestant = contestant;
    child_ = std::make_unique<Child>(contestant.name + " " + contestant.variant,
                                     [&](Channel &channel) { serve(contestant, system.setup, channel); });
    child_->channel().set_patience(effort.patience);
  }

  // The first steps. False if the contestant has nothing to do with these particles.
  bool start() {
    bool suited = true;
    guarded([&] {
      suited = child_->channel().receive<bool>();
      if (!suited) return;
      run(1);  // memory is obtained here
      const double seconds = run(effort_->first_steps - 1);
      const double possible = effort_->turn_seconds * static_cast<double>(effort_->first_steps - 1) / seconds;
      result_.steps = std::max<uint64_t>(1, std::min(effort_->steps, static_cast<uint64_t>(possible)));
      first_ = ask_state();
      if (result_.contestant.tuned) trial_ = run(result_.steps) / static_cast<double>(result_.steps);
    });
    return suited;
  }
  void compare(const MotionState &reference) {
    if (!result_.fault.empty()) return;
    const double smallest = *std::min_element(system_->setup.radii.begin(), system_->setup.radii.end());
    const double apart = largest_difference(first_.centers, reference.centers) / smallest;
    if (!(apart <= kSameMotion)) result_.fault = "apart by " + std::to_string(apart) + " of the smallest radius";
  }
  void run_again() {
    if (!child_) return;
    guarded([&] { result_.seconds.push_back(run(result_.steps) / static_cast<double>(result_.steps)); });
  }
  void finish() {
    if (!child_) return;
    guarded([&] {
      const Sums before = sums_of(system_->setup, first_), after = sums_of(system_->setup, ask_state());
      result_.energy_change = (after.energy() - before.energy()) / before.energy();
      result_.contacts = static_cast<double>(after.contacts) / static_cast<double>(system_->setup.count());
      child_->channel().send(Order::kSendDetails);
      result_.details = child_->channel().receive<Details>();
    });
    end();
  }
  void lose() {
    end();
    result_.chosen = false;
    if (trial_ > 0) result_.seconds.push_back(trial_);
  }

  bool works() const { return result_.fault.empty(); }
  double trial() const { return trial_; }
  const MotionState &first_state() const { return first_; }
  const StepResult &result() const { return result_; }

 private:
  double run(uint64_t steps) {
    child_->channel().send(Order::kRun);
    child_->channel().send(steps);
    const auto seconds = child_->channel().receive<double>();
    // Threads spin for some milliseconds before they sleep; the next contestant shall not pay for that.
    if (result_.contestant.threads != 1) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return seconds;
  }
  MotionState ask_state() {
    child_->channel().send(Order::kSendState);
    MotionState state;
    state.centers = child_->channel().receive_array<double>();
    state.velocities = child_->channel().receive_array<double>();
    return state;
  }
  void end() {
    if (!child_) return;
    child_->channel().send(Order::kEnd);
    child_->wait();
    child_.reset();
  }
  template <class Talk>
  void guarded(Talk talk) {
    try {
      talk();
    } catch (const PatienceEnded &ended) {
      result_.fault = ended.what();
      child_.reset();
    } catch (const ProcessEnded &) {
      result_.fault = "broke down: " + child_->wait();
      child_.reset();
    }
  }

  const SettledSystem *system_;
  const StepEffort *effort_;
  StepResult result_;
  std::unique_ptr<Child> child_;
  MotionState first_;
  double trial_ = 0;
};

using Runners = std::vector<std::unique_ptr<StepRunner>>;

// Of the variants of one name and number of threads only the fastest goes on; those that broke down lose against any
// that did not.
void drop_slower_variants(Runners &runners) {
  for (const auto &runner : runners) {
    const StepResult &own = runner->result();
    if (!own.contestant.tuned || !own.chosen) continue;
    const bool beaten = std::any_of(runners.begin(), runners.end(), [&](const auto &other) {
      const StepContestant &rival = other->result().contestant;
      return other != runner && rival.name == own.contestant.name && rival.threads == own.contestant.threads &&
             rival.tuned && other->result().chosen && other->works() &&
             (!runner->works() || other->trial() < runner->trial());
    });
    if (beaten) runner->lose();
  }
}

}  // namespace

std::vector<StepResult> run_step_rounds(const SettledSystem &system, const std::vector<StepContestant> &contestants,
                                        const StepEffort &effort) {
  Runners runners;
  MotionState reference;
  for (const StepContestant &contestant : contestants) {
    runners.push_back(std::make_unique<StepRunner>(contestant, system, effort));
    if (!runners.back()->start()) {
      runners.pop_back();
      continue;
    }
    if (reference.centers.empty()) reference = runners.back()->first_state();
    runners.back()->compare(reference);
    drop_slower_variants(runners);
  }
  for (int round = 0; round < effort.repeats; round++) {
    for (const auto &runner : runners) runner->run_again();
    std::reverse(runners.begin(), runners.end());  // nobody always follows the same neighbour
  }
  if (effort.repeats % 2 == 1) std::reverse(runners.begin(), runners.end());
  std::vector<StepResult> results;
  for (const auto &runner : runners) {
    runner->finish();
    results.push_back(runner->result());
  }
  return results;
}

}  // namespace bench
