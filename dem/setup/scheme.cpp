// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Integration schemes as lists of kicks and drifts.
#include "dem/setup/scheme.hpp"

#include "dem/base/error.hpp"

#include <cmath>

namespace dem {

Scheme velocity_verlet() { return {"velocity-verlet", 2, {{1, 1}}, 0.5, 0}; }

Scheme symplectic_euler() { return {"symplectic-euler", 1, {{1, 1}}, 0, 0}; }

Scheme leapfrog() { return {"leapfrog", 2, {{1, 1}}, 0, 0.5}; }

Scheme forest_ruth() {
  const double theta = 1 / (2 - std::cbrt(2.0));
  const double middle = 1 - 2 * theta;
  return {"forest-ruth", 4, {{theta, theta}, {(theta + middle) / 2, middle}, {(theta + middle) / 2, theta}},
          theta / 2,     0, 2.475};
}

Scheme scheme_of_name(const std::string &name) {
  for (const Scheme &scheme : {velocity_verlet(), symplectic_euler(), leapfrog(), forest_ruth()}) {
    if (scheme.name == name) return scheme;
  }
  throw Error("no scheme is called '" + name + "': use velocity-verlet, symplectic-euler, leapfrog or forest-ruth");
}

}  // namespace dem
