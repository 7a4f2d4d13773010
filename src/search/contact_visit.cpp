// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/contact_visit.hpp"

#include <algorithm>

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

// vector_of(pair, a, b, room) is the vector of a pair of slots a and b, where it is kept or in the room.
template <class VectorOf>
bool ContactVisit::take_each(const hg_pair *pairs, size_t count, VectorOf &&vector_of) {
  for (size_t first = 0; first < count; first += HG_MAX_BATCH) {
    const size_t batch = std::min<size_t>(HG_MAX_BATCH, count - first);
    for (size_t k = 0; k < batch; k++) {
      const hg_pair pair = pairs[first + k];
      const size_t a = store_.slot(pair.a), b = store_.slot(pair.b);
      double room[3];
      const double *vector = vector_of(first + k, a, b, room);
      a_[k] = pair.a;
      b_[k] = pair.b;
      for (size_t axis = 0; axis < dimension_; axis++) component_[axis][k] = vector[axis];
      reach_[k] = geometry_.reach(a, b);
    }
    if (!hand_over(batch)) return false;
  }
  return true;
}

bool ContactVisit::take(const hg_pair *pairs, size_t count) {
  return take_each(pairs, count, [this](size_t, size_t a, size_t b, double *room) {
    geometry_.find(a, b, room);
    return room;
  });
}

bool ContactVisit::take(const hg_pair *pairs, const double *vectors, size_t count) {
  return take_each(pairs, count, [=](size_t pair, size_t, size_t, double *) { return vectors + pair * dimension_; });
}

bool ContactVisit::hand_over(size_t count) {
  const double *z = dimension_ == 3 ? component_[2].data() : nullptr;
  const hg_contact_batch batch{count, a_.data(),    b_.data(), component_[0].data(), component_[1].data(),
                               z,     reach_.data()};
  return visit_(context_, &batch) == 0;
}

}  // namespace hg
