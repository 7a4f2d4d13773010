// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/particles/short_cell.hpp"

#include "src/base/error.hpp"
#include "src/space/shift_table.hpp"

#include <algorithm>

namespace hg {

bool ShortCell::is_long_for(double radius) const {
  if (!domain_.any_periodic) return true;
  const double reach = interaction_.diameter(radius);
  return 2 * reach * (1 + 0x1p-20) <= short_.shortest && may_list(domain_, reach);
}

// Through two images a pair is met at distances whose difference is a vector of the lattice, so not if that is at least
// twice their reach. The two largest particles have the longest.
void ShortCell::check(const TwoLargest &largest, const int32_t (&ids)[2]) const {
  if (largest.count == 0 || (largest.count == 1 && !domain_.all_images)) return;
  const double reach = interaction_.diameter(largest.radius[0]);
  if (!may_list(domain_, reach)) {
    fail(HG_ERR_LIMIT, "particle %d with radius %g reaches across too many periodic cells", static_cast<int>(ids[0]),
         largest.radius[0]);
  }
  if (domain_.all_images) return;
  ExactSum twice_reach;
  interaction_.add_reach(twice_reach, largest.radius[0], largest.radius[1]);
  for (int n = 0; n < twice_reach.count; n++) twice_reach.terms[n].factor *= 2;
  const Shift *end = short_.shift + short_.count;
  if (std::none_of(short_.shift, end, [&](const Shift &s) { return is_shorter(domain_, s, twice_reach); })) return;
  fail(HG_ERR_ARGUMENT,
       "particles %d and %d with radii %g and %g could meet twice: the periodic cell is %g long where it is shortest, "
       "shorter than twice their reach %g",
       static_cast<int>(ids[0]), static_cast<int>(ids[1]), largest.radius[0], largest.radius[1], short_.shortest,
       interaction_.reach(largest.radius[0], largest.radius[1]));
}

}  // namespace hg
