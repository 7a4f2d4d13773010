// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Makes the engine that a setup asks for.
#include "dem/engine/engine.hpp"

#include "dem/base/error.hpp"
#include "dem/engine/simulation.hpp"
#include "dem/setup/space_order.hpp"
#include "dem/setup/time_step.hpp"

#include <utility>

namespace dem {
namespace {

// Schemes other than one kick and one drift per step are for comparing integrators on simple contacts.
void check_scheme(const Setup &setup) {
  const Scheme &scheme = setup.scheme;
  const EffectSet memory = setup.effects & (kFriction | kRolling | kShear | kGrowth);
  if ((scheme.stages.size() > 1 || scheme.shared_drift != 0) && memory != 0) {
    throw Error("the scheme " + scheme.name + " does not go together with " + names_of(memory));
  }
  const EffectSet losses = setup.effects & (kDissipation | kDrag);
  if (scheme.stages.size() > 1 && losses != 0) {
    throw Error("the scheme " + scheme.name + " goes back in time, which does not go together with " +
                names_of(losses));
  }
}

template <class Real>
std::unique_ptr<Engine> make_engine_in(const Setup &setup) {
  std::vector<uint32_t> order = space_order(setup);
  const Setup sorted = reordered(setup, order);
  if (setup.dimension == 2) return std::make_unique<Simulation<2, Real>>(sorted, std::move(order));
  return std::make_unique<Simulation<3, Real>>(sorted, std::move(order));
}

}  // namespace

std::unique_ptr<Engine> make_engine(const Setup &setup, Precision precision) {
  check_setup(setup);
  require_time_step(setup);
  check_scheme(setup);
  return precision == Precision::kFloat ? make_engine_in<float>(setup) : make_engine_in<double>(setup);
}

}  // namespace dem
