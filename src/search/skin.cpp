// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/skin.hpp"

#include "src/search/pair_search.hpp"
#include "src/space/fixed_point.hpp"

#include <algorithm>
#include <limits>

namespace hg {
namespace {

// The share of all pairs of evenly spread points that are nearer than the skin, or less.
double share_within(double skin, const Bounds &bounds, int dimension) {
  double share = 1;
  for (int axis = 0; axis < dimension; axis++) share *= std::min(1.0, skin / bounds.width[axis]);
  return share;
}

}  // namespace

double usable_skin(double wanted, const Interaction &interaction, const Domain &domain, const Bounds &bounds,
                   int32_t accuracy, size_t particles) {
  double extent = 0;
  for (int axis = 0; axis < domain.dimension; axis++) extent = std::max(extent, bounds.max[axis] - bounds.min[axis]);
  double skin = std::min(wanted, extent);
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (!domain.periodic[axis]) continue;
    // The wider reach, too, must meet one image of a particle at most.
    skin = std::min(skin, 0.5 * domain.length[axis] * (1 - 0x1p-40) - interaction.diameter(bounds.max_radius));
  }
  const Interaction wide = interaction.widened(skin);
  const double reach = wide.diameter(bounds.max_radius);
  if (!(skin > 0 && reach <= 0.5 * std::numeric_limits<double>::max())) return 0;
  const double scale = FixedPoint::over(bounds, domain, reach).scale;
  if ((wide.margin - interaction.margin) * scale < kLeastQuanta) return 0;
  if (!plain_squares_are_clear(accuracy, scale, reach)) return 0;
  const double expected = 0.5 * static_cast<double>(particles) * share_within(skin, bounds, domain.dimension);
  return expected <= static_cast<double>(kMostCandidatesPerParticle) ? skin : 0;
}

}  // namespace hg
