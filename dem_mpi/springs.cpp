// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows of springs from what contacts remember, and back.
#include "dem_mpi/springs.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace dem::ranks {
namespace {

// Where a name stands among the particles of a rank.
class Places {
 public:
  explicit Places(const std::vector<int64_t> &names) {
    for (size_t i = 0; i < names.size(); i++) sorted_.emplace_back(names[i], i);
    std::sort(sorted_.begin(), sorted_.end());
  }
  size_t of(int64_t name) const {
    const auto place = std::lower_bound(sorted_.begin(), sorted_.end(), std::make_pair(name, size_t{0}));
    if (place == sorted_.end() || place->first != name)
      throw std::logic_error("a contact of particle " + std::to_string(name) + ", which this rank does not know");
    return place->second;
  }

 private:
  std::vector<std::pair<int64_t, size_t>> sorted_;
};

Spring spring_at(const ContactMemory &memory, size_t p, int64_t partner, int dimension) {
  Spring spring;
  spring.partner = partner;
  const auto width = static_cast<size_t>(dimension);
  for (size_t k = 0; k < kHistoryCount; k++) {
    if (!memory.rows[k].empty()) std::copy_n(&memory.rows[k][width * p], width, spring.rows[k]);
  }
  return spring;
}

void add(const hg_pair &pair, const Spring &spring, int dimension, ContactMemory &memory) {
  memory.pairs.push_back(pair);
  for (size_t k = 0; k < kHistoryCount; k++)
    memory.rows[k].insert(memory.rows[k].end(), spring.rows[k], spring.rows[k] + dimension);
}

}  // namespace

std::vector<std::vector<Spring>> springs_of(const KnownParticles &particles, const ContactMemory &pairs,
                                            const ContactMemory &walls, int dimension) {
  std::vector<std::vector<Spring>> springs(particles.owned);
  const Places places(*particles.names);
  const std::vector<double> &radii = *particles.radii;
  for (size_t p = 0; p < pairs.pairs.size(); p++) {
    const int64_t a = pairs.pairs[p].a, b = pairs.pairs[p].b;
    const size_t i = places.of(a), j = places.of(b);
    const bool first_keeps = radii[i] <= radii[j];  // of equal ones the smaller name, which comes first
    springs.at(first_keeps ? i : j).push_back(spring_at(pairs, p, first_keeps ? b : a, dimension));
  }
  for (size_t p = 0; p < walls.pairs.size(); p++) {
    springs.at(places.of(walls.pairs[p].a)).push_back(spring_at(walls, p, -2 - walls.pairs[p].b, dimension));
  }
  return springs;
}

Memories memories_of(const std::vector<int64_t> &names, const std::vector<Spring> &springs, size_t width,
                     int dimension) {
  Memories result;
  for (size_t k = 0; k < springs.size(); k++) {
    const auto name = static_cast<int32_t>(names[k / width]);
    const Spring &spring = springs[k];
    const auto partner = static_cast<int32_t>(spring.partner);
    if (partner >= 0) add({std::min(name, partner), std::max(name, partner)}, spring, dimension, result.pairs);
    if (partner < -1) add({name, -2 - partner}, spring, dimension, result.walls);
  }
  return {joined({result.pairs}, dimension), joined({result.walls}, dimension)};
}

ContactMemory joined(const std::vector<ContactMemory> &memories, int dimension) {
  ContactMemory all, result;
  for (const ContactMemory &memory : memories) {
    for (size_t p = 0; p < memory.pairs.size(); p++)
      add(memory.pairs[p], spring_at(memory, p, 0, dimension), dimension, all);
  }
  std::vector<size_t> order(all.pairs.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t x, size_t y) {
    const hg_pair &p = all.pairs[x], &q = all.pairs[y];
    return p.a != q.a ? p.a < q.a : p.b < q.b;
  });
  for (const size_t p : order) add(all.pairs[p], spring_at(all, p, 0, dimension), dimension, result);
  return result;
}

}  // namespace dem::ranks
