// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// From a request to the growth of its particles and back to a set of particles.
#include "packing/event/grown_packing.hpp"

#include "packing/event/overlaps.hpp"
#include "particles/error.hpp"
#include "particles/text/number.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace packing::event {
namespace {

void require_no_overlaps(const Box &box, const GrowthResult &growth) {
  const size_t overlaps = count_overlaps(box, growth.centers, growth.radii);
  const size_t beyond = count_beyond_walls(box, growth.centers, growth.radii);
  if (overlaps == 0 && beyond == 0) return;
  throw particles::Error("the growth left " + std::to_string(overlaps) + " overlaps and " + std::to_string(beyond) +
                         " particles beyond walls: please report this");
}

// A few large particles that cannot pass each other jam at a density of their own, whatever lies between them and how
// slowly all grow. They are tried alone first, which takes no time, so that no hours are spent on what cannot be.
void require_room_for_the_largest(const Box &box, const std::vector<double> &radii, uint64_t seed) {
  constexpr size_t kFew = 32;
  GrowthRequest alone;
  alone.radii = radii;
  std::sort(alone.radii.begin(), alone.radii.end(), std::greater<>());
  const double smallest = alone.radii.front() / 3;
  const auto large = [smallest](double radius) { return radius > smallest; };
  const auto count = std::count_if(alone.radii.begin(), alone.radii.end(), large);
  if (static_cast<size_t>(count) > kFew || static_cast<size_t>(count) == radii.size()) return;
  alone.radii.resize(static_cast<size_t>(count));
  alone.seed = seed;
  const GrowthResult growth = grow(box, alone);
  if (growth.end == GrowthEnd::kDone) return;
  throw particles::Error("the box is too small for its largest particles: " + std::to_string(count) + " of radius " +
                         particles::text(alone.radii.back()) + " to " + particles::text(alone.radii.front()) +
                         " jam when they alone have grown to " +
                         particles::text(growth.radii.front() / alone.radii.front()) +
                         " of that; take more particles, a lower density or a smaller ratio");
}

}  // namespace

GrownPacking grow_packing(const Request &request, double rate, const GrowthObserver &observe) {
  Beginning beginning = begin_packing(request);
  const Box &box = beginning.box;
  require_room_for_the_largest(box, beginning.radii, request.seed);
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
