// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Makes the engine that a setup asks for.
#include "dem/engine/engine.hpp"

#include "dem/base/error.hpp"
#include "dem/engine/simulation.hpp"
#include "dem/setup/space_order.hpp"
#include "dem/setup/time_step.hpp"

namespace dem {
namespace {

// Schemes other than one kick and one drift per step are for comparing integrators on simple contacts.
void check_scheme(const Setup &setup) {
  const Scheme &scheme = setup.scheme;
  const EffectSet stateful = setup.effects & effects_with(kStateful);
  if ((scheme.stages.size() > 1 || scheme.shared_drift != 0) && stateful != 0) {
    throw Error("the scheme " + scheme.name + " does not go together with " + names_of(stateful));
  }
  const EffectSet lossy = setup.effects & effects_with(kLossy);
  if (scheme.stages.size() > 1 && lossy != 0) {
    throw Error("the scheme " + scheme.name + " goes back in time, which does not go together with " + names_of(lossy));
  }
}

// Who comes is one size for good and in one box; and comes where places and velocities are of the same step or half a
// step apart.
void check_exchange(const Setup &setup) {
  if (!setup.exchanges()) return;
  const EffectSet others = setup.effects & (kShear | kGrowth);
  if (others != 0) throw Error("inflows and removals do not go together with " + names_of(others));
  if (setup.scheme.stages.size() > 1 || setup.scheme.shared_drift != 0)
    throw Error("inflows and removals do not go together with the scheme " + setup.scheme.name);
}

template <class Real>
std::unique_ptr<Engine> make_engine_in(const Setup &setup) {
  const std::vector<uint32_t> order = space_order(setup);
  const Setup sorted = reordered(setup, order);
  if (setup.dimension == 2) return std::make_unique<Simulation<2, Real>>(sorted, inverse(order));
  return std::make_unique<Simulation<3, Real>>(sorted, inverse(order));
}

}  // namespace

std::unique_ptr<Engine> make_engine(const Setup &setup, Precision precision) {
  check_setup(setup);
  require_time_step(setup);
  check_scheme(setup);
  check_exchange(setup);
  return precision == Precision::kFloat ? make_engine_in<float>(setup) : make_engine_in<double>(setup);
}

}  // namespace dem
