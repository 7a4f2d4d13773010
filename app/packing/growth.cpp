// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// From a request to the growth of its particles and back to a set of particles.
#include "packing/growth.hpp"

#include "error.hpp"
#include "sim/box.hpp"
#include "sim/event/overlaps.hpp"

#include <string>
#include <utility>

namespace packing {
namespace {

namespace event = hgrid_sim::event;

hgrid_sim::Box box_of(const Container &container) {
  const hgrid_sim::Vector edge = hgrid_sim::Vector::Constant(container.edge);
  return hgrid_sim::Box(container.dimension, edge, container.periodic);
}

void require_no_overlaps(const hgrid_sim::Box &box, const event::GrowthResult &growth) {
  const std::size_t overlaps = event::count_overlaps(box, growth.centers, growth.radii);
  const std::size_t beyond = event::count_beyond_walls(box, growth.centers, growth.radii);
  if (overlaps == 0 && beyond == 0) return;
  throw app::Error("the growth left " + std::to_string(overlaps) + " overlaps and " + std::to_string(beyond) +
                   " particles beyond walls: please report this");
}

}  // namespace

GrownPacking grow_packing(const Request &request, double rate, const event::GrowthObserver &observe) {
  Beginning beginning = begin_packing(request);
  const hgrid_sim::Box box = box_of(beginning.container);
  event::GrowthRequest wanted;
  wanted.radii = std::move(beginning.radii);
  wanted.seed = beginning.random.next();
  wanted.rate = rate;
  GrownPacking packing;
  packing.growth = event::grow(box, wanted, observe);
  require_no_overlaps(box, packing.growth);
  packing.particles = beginning.container.empty_set();
  packing.particles.radii = packing.growth.radii;
  for (const hgrid_sim::Vector &center : packing.growth.centers) {
    packing.particles.centers.insert(packing.particles.centers.end(), center.data(), center.data() + box.dimension());
  }
  return packing;
}

}  // namespace packing
