// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Hands contacts with their geometry to a visitor, in batches.
#pragma once

#include "src/base/memory.hpp"
#include "src/search/pair_geometry.hpp"

#include <hgrid/types.h>

#include <cstddef>

namespace hg {

class ContactVisit {
 public:
  ContactVisit(const PairGeometry &geometry, const ParticleStore &store, int dimension, Memory &memory,
               hg_contact_visitor *visit, void *context);

  // Pairs of ids that have one image each. False once the visitor has had enough.
  bool take(const hg_pair *pairs, size_t count);
  // Pairs whose vectors, [count][dimension], are known.
  bool take(const hg_pair *pairs, const double *vectors, size_t count);

 private:
  void fetch(const hg_pair &pair) const;
  template <size_t D, class VectorOf>
  bool take_each(const hg_pair *pairs, size_t count, VectorOf &&vector_of);
  bool hand_over(size_t count);

  const PairGeometry &geometry_;
  const ParticleStore &store_;
  size_t dimension_;
  Buffer<int32_t> a_, b_;
  Buffer<double> component_[3], reach_;
  hg_contact_visitor *visit_;
  void *context_;
};

}  // namespace hg
