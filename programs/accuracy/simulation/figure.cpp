// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/figure.hpp"

#include "dem/setup/time_step.hpp"
#include "programs/accuracy/simulation/studies.hpp"

namespace accuracy {
namespace {

bool of_step(const Point &p, const char *error_of) {
  return p.parameter == "step" && p.system == "velocity-verlet" && p.error_of == error_of;
}

}  // namespace

// All settings but the step itself were timed per step, with the usual number of them in a contact.
const Figure &simulation_figure() {
  static const Figure figure = {
      "What does accuracy of the simulation cost?",
      "ns per particle and t_c of simulated time, the duration of a contact",
      {{"Which time step? Linear springs",
        {"restitution off by, any n;", "n = t_c / dt"},
        [](const Point &p) { return of_step(p, "restitution, any n"); },
        setting_of},
       {"\u2026 with a dashpot",
        {"restitution off by, e = 0.527"},
        [](const Point &p) { return of_step(p, "restitution, damped"); },
        setting_of},
       {"\u2026 with friction",
        {"speed of the surfaces off by, over", "that of the impact, e = 0.8, mu = 0.5"},
        [](const Point &p) { return of_step(p, "slip, friction"); },
        setting_of},
       {"\u2026 of Hertz contacts",
        {"restitution off by, e = 1"},
        [](const Point &p) { return of_step(p, "restitution, Hertz"); },
        setting_of},
       {"Which scheme?",
        {"energy of a gas off by after 25 t_c,", "n = 50"},
        [](const Point &p) {
          return p.parameter == "step" && p.error_of == "energy change in 25 t_c" && p.setting == "n = 50";
        },
        system_of},
       {"Float or double?",
        {"overlaps off by after one t_c,", "box of 81 radii, n = 50"},
        [](const Point &p) {
          return p.parameter == "state" && p.error_of == "overlaps after one t_c" &&
                 p.system == "50653 spheres, box of 81 radii";
        },
        setting_of,
        dem::kUsualStepsPerContact},
       {"Which skin?",
        {"particles elsewhere, equal spheres", "of density 0.4, n = 50"},
        [](const Point &p) { return p.parameter == "skin" && p.system == "equal spheres, density 0.4"; },
        setting_of,
        dem::kUsualStepsPerContact}}};
  return figure;
}

}  // namespace accuracy
