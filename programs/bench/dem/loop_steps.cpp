// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The plain loop in C over the library's contacts, examples/elastic_steps.c, as a contestant.
#include "dem/setup/space_order.hpp"
#include "examples/elastic_steps.h"
#include "programs/bench/dem/stepper.hpp"

#include <hgrid/hgrid.hpp>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace bench {
namespace {

class LoopSteps {
 public:
  LoopSteps(const dem::Setup &given, double skin)
      : order_(dem::space_order(given)), setup_(dem::reordered(given, order_)), forces_(3 * given.count()) {
    hg_grid_def def = hg_default_grid_def();
    def.thread_count = 1;
    def.skin = skin * *std::min_element(setup_.radii.begin(), setup_.radii.end());
    grid_ = std::make_unique<hgrid::Grid>(def);
    grid_->insert(setup_.count(), setup_.centers.data(), setup_.radii.data());
    for (const double mass : setup_.masses) inverse_masses_.push_back(1 / mass);
    spheres_.count = setup_.count();
    spheres_.x = setup_.centers.data();
    spheres_.v = setup_.velocities.data();
    spheres_.f = forces_.data();
    spheres_.radius = setup_.radii.data();
    spheres_.inverse_mass = inverse_masses_.data();
    std::copy_n(setup_.box_min, 3, spheres_.low);
    std::copy_n(setup_.box_max, 3, spheres_.high);
    spheres_.stiffness = setup_.contact.stiffness;
    spheres_.step = setup_.time_step;
    spheres_.grid = grid_->get();
    kick(-setup_.time_step / 2);
  }

  void run(uint64_t steps) {
    for (; steps > 0; steps--) hgrid::check(one_step(&spheres_));
  }

  MotionState state() {
    dem::Setup now = setup_;
    kick(setup_.time_step / 2);
    now.velocities.swap(setup_.velocities);
    spheres_.v = setup_.velocities.data();
    dem::reorder(now, dem::inverse(order_));
    return {std::move(now.centers), std::move(now.velocities)};
  }

 private:
  // The velocities alone; the loop's run half a step behind.
  void kick(double time) {
    const std::vector<double> start = setup_.centers;
    spheres_.step = time;
    hgrid::check(one_step(&spheres_));
    spheres_.step = setup_.time_step;
    std::copy(start.begin(), start.end(), setup_.centers.begin());
    grid_->move(setup_.count(), setup_.centers.data());
  }

  std::vector<uint32_t> order_;
  dem::Setup setup_;
  std::vector<double> forces_, inverse_masses_;
  std::unique_ptr<hgrid::Grid> grid_;
  spheres spheres_{};
};

}  // namespace

StepContestant loop_steps(const StepSetting &setting, const std::string &isa) {
  StepContestant contestant;
  contestant.name = "c-loop";
  contestant.isa = isa;
  contestant.skin = setting.skin;
  contestant.tuned = setting.tuned;
  contestant.prepare = [setting](const dem::Setup &setup) {
    const auto steps = std::make_shared<LoopSteps>(setup, setting.skin);
    Stepper stepper;
    stepper.run = [steps](uint64_t count) { steps->run(count); };
    stepper.state = [steps] { return steps->state(); };
    stepper.details = [] { return Details(); };
    return stepper;
  };
  return contestant;
}

}  // namespace bench
