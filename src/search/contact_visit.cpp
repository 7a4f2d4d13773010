// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/contact_visit.hpp"

#include <algorithm>
#include <type_traits>

namespace hg {

ContactVisit::ContactVisit(const PairGeometry &geometry, const ParticleStore &store, int dimension, Memory &memory,
                           hg_contact_visitor *visit, void *context)
    : geometry_(geometry),
      store_(store),
      dimension_(static_cast<size_t>(dimension)),
      a_(memory),
      b_(memory),
      component_{Buffer<double>(memory), Buffer<double>(memory), Buffer<double>(memory)},
      reach_(memory),
      visit_(visit),
      context_(context) {
  a_.require(HG_MAX_BATCH);
  b_.require(HG_MAX_BATCH);
  reach_.require(HG_MAX_BATCH);
  for (size_t axis = 0; axis < dimension_; axis++) component_[axis].require(HG_MAX_BATCH);
}

// Centres and radii of a pair, on their way from memory: ids jump about in it.
void ContactVisit::fetch(const hg_pair &pair) const {
  for (const int32_t id : {pair.a, pair.b}) {
    const size_t slot = store_.slot(id);
    __builtin_prefetch(store_.center(slot));
    __builtin_prefetch(store_.radii() + slot);
  }
}

// vector_of(pair, a, b, room) is the vector of a pair of slots a and b, where it is kept or in the room.
template <size_t D, class VectorOf>
bool ContactVisit::take_each(const hg_pair *pairs, size_t count, VectorOf &&vector_of) {
  constexpr size_t kAhead = 16;
  for (size_t first = 0; first < count; first += HG_MAX_BATCH) {
    const size_t batch = std::min<size_t>(HG_MAX_BATCH, count - first);
    for (size_t k = 0; k < batch; k++) {
      if (store_.contiguous() && first + k + kAhead < count) fetch(pairs[first + k + kAhead]);
      const hg_pair pair = pairs[first + k];
      const size_t a = store_.slot(pair.a), b = store_.slot(pair.b);
      double room[D];
      const double *vector = vector_of(first + k, a, b, room);
      a_[k] = pair.a;
      b_[k] = pair.b;
      for (size_t axis = 0; axis < D; axis++) component_[axis][k] = vector[axis];
      reach_[k] = geometry_.reach(a, b);
    }
    if (!hand_over(batch)) return false;
  }
  return true;
}

bool ContactVisit::take(const hg_pair *pairs, size_t count) {
  const auto find = [this](auto dimension) {
    return [this](size_t, size_t a, size_t b, double *room) {
      geometry_.find<decltype(dimension)::value>(a, b, room);
      return room;
    };
  };
  using Flat = std::integral_constant<int, 2>;
  using Solid = std::integral_constant<int, 3>;
  return dimension_ == 3 ? take_each<3>(pairs, count, find(Solid())) : take_each<2>(pairs, count, find(Flat()));
}

bool ContactVisit::take(const hg_pair *pairs, const double *vectors, size_t count) {
  const auto look_up = [=](size_t pair, size_t, size_t, double *) { return vectors + pair * dimension_; };
  return dimension_ == 3 ? take_each<3>(pairs, count, look_up) : take_each<2>(pairs, count, look_up);
}

bool ContactVisit::hand_over(size_t count) {
  const double *z = dimension_ == 3 ? component_[2].data() : nullptr;
  const hg_contact_batch batch{count, a_.data(),    b_.data(), component_[0].data(), component_[1].data(),
                               z,     reach_.data()};
  return visit_(context_, &batch) == 0;
}

}  // namespace hg
