// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/simulation/studies.hpp"

namespace accuracy {

const std::vector<Study> &simulation_studies() {
  static const std::vector<Study> studies = {
      {"step", "Integration scheme and time step",
       "`time.scheme` and `time.steps_per_contact` of a scene, n = t_c / dt. Error: rms over 400 collisions, or of an "
       "elastic gas of 125 spheres. Time: ns per particle and t_c of simulated time, a gas of 4096 spheres.",
       measure_time_steps},
      {"state", "Numbers of the state",
       "`run.precision` of a scene. Error: against the same particles in double. Time: ns per particle and step.",
       measure_state_precision},
      {"rounding", "Time step of a state in float",
       "`time.steps_per_contact` and `run.precision` of a scene. Error: of an elastic gas of 125 spheres in a box of "
       "14 radii. Time: ns per particle and t_c of simulated time, a gas of 4096 spheres.",
       measure_rounding},
      {"skin", "Skin of the stored candidates",
       "`run.skin` of a scene, over the smallest radius. Error: particles that are elsewhere, to the last bit, than "
       "without skin. Time: ns per particle and step.",
       measure_skin_lengths}};
  return studies;
}

}  // namespace accuracy
