// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// From a request to the growth of its particles and back to a set of particles.
#include "packing/event/grown_packing.hpp"

#include "packing/event/overlaps.hpp"
#include "particles/error.hpp"

#include <string>
#include <utility>

namespace packing::event {
namespace {

void require_no_overlaps(const Box &box, const GrowthResult &growth) {
  const size_t overlaps = count_overlaps(box, growth.centers, growth.radii);
  const size_t beyond = count_beyond_walls(box, growth.centers, growth.radii);
  if (overlaps == 0 && beyond == 0) return;
  throw particles::Error("the growth left " + std::to_string(overlaps) + " overlaps and " + std::to_string(beyond) +
                         " particles beyond walls: please report this");
}

}  // namespace

GrownPacking grow_packing(const Request &request, double rate, const GrowthObserver &observe) {
  Beginning beginning = begin_packing(request);
  const Box &box = beginning.box;
  GrowthRequest wanted;
  wanted.radii = std::move(beginning.radii);
  wanted.seed = beginning.random.next();
  wanted.rate = rate;
  GrownPacking packing;
  packing.growth = grow(box, wanted, observe);
  require_no_overlaps(box, packing.growth);
  packing.particles = box.empty_set();
  packing.particles.radii = packing.growth.radii;
  for (const Vector &center : packing.growth.centers) {
    packing.particles.centers.insert(packing.particles.centers.end(), center.data(), center.data() + box.dimension());
  }
  return packing;
}

}  // namespace packing::event
