// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// LAMMPS as a contestant: gran/hooke between spheres and on walls, no damping, no friction, no rotation.
#include "programs/bench/dem/stepper.hpp"
#include "programs/bench/peers/lammps_session.hpp"

#include <algorithm>
#include <memory>

namespace bench {
namespace {

class LammpsSteps {
 public:
  LammpsSteps(const dem::Setup &setup, double skin, int collections);

  void run(uint64_t steps);
  MotionState state() const;

 private:
  void add_walls(const dem::Setup &setup);
  void set_particles(const dem::Setup &setup);

  size_t count_;
  LammpsSession lammps_;
  bool begun_ = false;
};

Particles view(const dem::Setup &setup) { return {setup.count(), setup.centers.data(), setup.radii.data()}; }

LammpsSteps::LammpsSteps(const dem::Setup &setup, double skin, int collections)
    : count_(setup.count()), lammps_(view(setup), "none") {
  lammps_.sort_atoms_every(1000);  // as LAMMPS does by itself
  // k_n k_t gamma_n gamma_t friction, and whether the tangential direction is damped.
  lammps_.command("pair_style gran/hooke %.17g 0 0 0 0 0", setup.contact.stiffness);
  lammps_.command("pair_coeff * *");
  lammps_.choose_neighbor_list(skin, collections);
  lammps_.command("neigh_modify delay 0 every 1 check yes");
  lammps_.command("timestep %.17g", setup.time_step);
  lammps_.command("fix motion all nve");
  add_walls(setup);
  lammps_.command("thermo 0");
  lammps_.command("timer off");
  set_particles(setup);
}

void LammpsSteps::add_walls(const dem::Setup &setup) {
  for (int k = 0; k < 3; k++) {
    if (!setup.walled[k]) continue;
    lammps_.command("fix wall%d all wall/gran hooke %.17g 0 0 0 0 0 %cplane %.17g %.17g", k, setup.contact.stiffness,
                    "xyz"[k], setup.box_min[k], setup.box_max[k]);
  }
}

void LammpsSteps::set_particles(const dem::Setup &setup) {
  const int *tags = lammps_.tags();
  double **v = lammps_.vectors("v");
  double *radius = lammps_.scalars("radius"), *mass = lammps_.scalars("rmass");
  for (size_t i = 0; i < count_; i++) {
    const size_t particle = static_cast<size_t>(tags[i]) - 1;
    for (size_t k = 0; k < 3; k++) v[i][k] = setup.velocities[3 * particle + k];
    radius[i] = setup.radii[particle];
    mass[i] = setup.masses[particle];
  }
}

void LammpsSteps::run(uint64_t steps) {
  lammps_.command(begun_ ? "run %llu pre no post no" : "run %llu post no", static_cast<unsigned long long>(steps));
  begun_ = true;
}

MotionState LammpsSteps::state() const {
  MotionState state{std::vector<double>(3 * count_), std::vector<double>(3 * count_)};
  const int *tags = lammps_.tags();
  double **x = lammps_.vectors("x"), **v = lammps_.vectors("v");
  for (size_t i = 0; i < count_; i++) {
    const size_t particle = static_cast<size_t>(tags[i]) - 1;
    std::copy_n(x[i], 3, &state.centers[3 * particle]);
    std::copy_n(v[i], 3, &state.velocities[3 * particle]);
  }
  return state;
}

}  // namespace

StepContestant lammps_steps(const StepSetting &setting, int collections) {
  StepContestant contestant;
  contestant.name = collections == 0 ? "lammps-bin" : "lammps-multi";
  if (collections > 0) contestant.variant = "collections-" + std::to_string(collections);
  contestant.skin = setting.skin;
  contestant.tuned = setting.tuned;
  contestant.prepare = [setting, collections](const dem::Setup &setup) {
    const auto [smallest, largest] = std::minmax_element(setup.radii.begin(), setup.radii.end());
    Stepper stepper;
    if (collections > 0 && !(*largest > 1.01 * *smallest)) return stepper;  // all sizes are one
    const auto steps = std::make_shared<LammpsSteps>(setup, setting.skin * *smallest, collections);
    stepper.run = [steps](uint64_t count) { steps->run(count); };
    stepper.state = [steps] { return steps->state(); };
    stepper.details = [] { return Details(); };
    return stepper;
  };
  return contestant;
}

}  // namespace bench
