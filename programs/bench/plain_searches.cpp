// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The classical linked cells and the plain hierarchical grid, timed like all others.
#include "programs/bench/plain_searches.hpp"

#include "programs/bench/hashed_grid.hpp"
#include "programs/bench/hierarchical_grid.hpp"
#include "programs/bench/library_searches.hpp"
#include "programs/bench/linked_cell.hpp"
#include "programs/measure/timing.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace bench {
namespace {

struct State {
  std::vector<hg_pair> pairs;
  int64_t tested = 0;
  Details details;
};

// `find` takes the number of tested candidates and returns the pairs.
template <class Find>
Search plain_search(const particles::ParticleSet &set, const Details &details, Find find) {
  auto state = std::make_shared<State>();
  state->details = details;
  Search search;
  search.run = [state, find](PairView &pairs) {
    const double seconds = measure::seconds_of([&] { state->pairs = find(&state->tested); });
    pairs = {state->pairs.data(), state->pairs.size()};
    return seconds;
  };
  search.details = [state, count = set.count()] {
    state->details.candidates = static_cast<double>(state->tested) / static_cast<double>(count);
    return state->details;
  };
  return search;
}

Particles view(const particles::ParticleSet &set) { return {set.count(), set.centers.data(), set.radii.data()}; }

// m = max over levels of N_h s_h^d / V (section 3 of the paper), V the smallest box that holds all particles.
double largest_occupancy(const particles::ParticleSet &set, const std::vector<double> &sizes) {
  const size_t d = static_cast<size_t>(set.dimension);
  double volume = 1;
  for (size_t k = 0; k < d; k++) {
    double low = set.centers[k], high = low;
    for (size_t i = 0; i < set.count(); i++) {
      low = std::min(low, set.centers[i * d + k] - set.radii[i]);
      high = std::max(high, set.centers[i * d + k] + set.radii[i]);
    }
    volume *= high - low;
  }
  std::vector<double> held(sizes.size(), 0.0);
  for (const double r : set.radii) {
    const auto level = std::lower_bound(sizes.begin(), sizes.end(), 2 * r);
    if (level != sizes.end()) ++held[static_cast<size_t>(level - sizes.begin())];
  }
  double largest = 0;
  for (size_t h = 0; h < sizes.size(); h++) {
    largest = std::max(largest, held[h] * std::pow(sizes[h], set.dimension) / volume);
  }
  return largest;
}

using Sizes = std::vector<double>;

// A search on the levels of the paper: `find` takes the particles, the cell sizes and the number of tested candidates.
template <class Find>
Contestant multilevel_search(const char *name, int level_count, Find find) {
  Contestant contestant;
  contestant.name = name;
  if (level_count > 0) contestant.variant = "L" + std::to_string(level_count);
  contestant.prepare = [level_count, find](const particles::ParticleSet &set) {
    const Sizes sizes = cell_sizes_of_paper(set, level_count);
    Details details;
    details.levels = static_cast<double>(sizes.size());
    details.occupancy = largest_occupancy(set, sizes);
    return plain_search(set, details, [&set, sizes, find](int64_t *tested) { return find(set, sizes, tested); });
  };
  return contestant;
}

}  // namespace

Contestant linked_cell_search() {
  Contestant contestant;
  contestant.name = kClassical;
  contestant.prepare = [](const particles::ParticleSet &set) {
    Details details;
    details.levels = 1;
    return plain_search(set, details,
                        [&set](int64_t *tested) { return linked_cell_pairs(set.dimension, view(set), tested); });
  };
  return contestant;
}

Contestant hierarchical_grid_search(int level_count) {
  return multilevel_search(kPlain, level_count,
                           [](const particles::ParticleSet &set, const Sizes &sizes, int64_t *tested) {
                             return hierarchical_grid_pairs(set.dimension, view(set), sizes, tested);
                           });
}

Contestant hashed_grid_search(int level_count) {
  return multilevel_search(kHashed, level_count,
                           [](const particles::ParticleSet &set, const Sizes &sizes, int64_t *tested) {
                             return hashed_grid_pairs(view(set), sizes, tested);
                           });
}

}  // namespace bench
