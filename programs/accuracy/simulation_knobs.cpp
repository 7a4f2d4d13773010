// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list of the simulation's knobs.
#include "programs/accuracy/simulation_knobs.hpp"

#include "programs/accuracy/simulation/rounding_knob.hpp"
#include "programs/accuracy/simulation/skin_knob.hpp"
#include "programs/accuracy/simulation/state_knob.hpp"
#include "programs/accuracy/simulation/step_knob.hpp"

namespace accuracy {

const std::vector<Knob> &simulation_knobs() {
  static const std::vector<Knob> knobs = {
      {"step", "Integration scheme and time step",
       "`time.scheme` and `time.steps_per_contact` of a scene, n = t_c / dt. Error: rms over 400 collisions, or of an "
       "elastic gas of 125 spheres. Time: ns per particle and t_c of simulated time, a gas of 4096 spheres.",
       measure_steps},
      {"state", "Numbers of the state",
       "`run.precision` of a scene. Error: against the same particles in double. Time: ns per particle and step.",
       measure_states},
      {"rounding", "Time step of a state in float",
       "`time.steps_per_contact` and `run.precision` of a scene. Error: of an elastic gas of 125 spheres in a box of "
       "14 "
       "radii. Time: ns per particle and t_c of simulated time, a gas of 4096 spheres.",
       measure_rounding},
      {"skin", "Skin of the stored candidates",
       "`run.skin` of a scene, over the smallest radius. Error: particles that are elsewhere, to the last bit, than "
       "without skin. Time: ns per particle and step.",
       measure_run_skins}};
  return knobs;
}

}  // namespace accuracy
