// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Who may collide with whom: a hull around every particle, and lists of the particles whose hulls overlap (Donev,
// Torquato & Stillinger 2005).
#pragma once

#include "packing/box.hpp"
#include "packing/vector.hpp"

#include <hgrid/hgrid.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace packing::event {

struct Sphere {
  Vector center;
  double radius;
};

// A row of particle numbers, valid until the lists change.
struct Row {
  const int32_t *first;
  const int32_t *last;
  const int32_t *begin() const { return first; }
  const int32_t *end() const { return last; }
  size_t size() const { return static_cast<size_t>(last - first); }
};

// Two hulls are kept per particle. A particle stays within its inner hull; when it touches that, renew() gives it a new
// one around its place. Partners are the particles whose inner hulls overlap. The outer hulls stand still in a grid of
// the library from one rebuild() to the next: as long as inner hulls lie in their outer ones, new partners are found in
// the list of overlapping outer hulls, without a search. A particle that has come too far for that is a stray: its
// partners are sought in the grid, and every renewed hull is also tested against those of all strays.
//
// Complexity: rebuild O(N + overlapping outer hulls); renew O(outer partners + strays), for strays one query more.
class HullLists {
 public:
  HullLists(const Box &box, size_t count);

  // Gives every particle new hulls: spheres[i] with its radius enlarged by inner[i] and by outer[i] >= inner[i].
  // Throws hgrid::Error if a periodic axis is too short for the outer hulls.
  void rebuild(const std::vector<Sphere> &spheres, const std::vector<double> &inner, const std::vector<double> &outer);

  // Gives one particle, now at `sphere`, a new inner hull with this skin, less if that keeps it within its outer hull.
  // Returns the number of hulls it was tested against.
  size_t renew(int32_t particle, const Sphere &sphere, double skin);

  const Sphere &hull(int32_t particle) const { return inner_[index(particle)]; }
  Row partners(int32_t particle) const {
    const Slot &slot = slots_[index(particle)];
    return {pool_.data() + slot.begin, pool_.data() + slot.begin + slot.count};
  }
  size_t stray_count() const { return strays_.size(); }

  // The sum of the lengths of all lists of outer partners: twice the pairs.
  size_t outer_sum() const { return rows_.ids.size(); }

 private:
  // Where the partners of one particle stand in the pool.
  struct Slot {
    size_t begin;
    uint32_t count, capacity;
  };

  static size_t index(int32_t particle) { return static_cast<size_t>(particle); }
  bool overlap(const Sphere &a, const Sphere &b) const {
    const double reach = a.radius + b.radius;
    return square(box_.nearest(b.center - a.center)) < reach * reach;
  }

  bool fit_in_outer(int32_t particle, const Sphere &sphere, double skin);
  void fill_rows();
  template <class Visit>
  void visit_candidates(int32_t particle, Visit visit);
  void append(int32_t row, int32_t particle);
  void erase(int32_t row, int32_t particle);

  Box box_;
  hgrid::Grid grid_;
  bool filled_ = false;
  std::vector<Sphere> outer_, inner_;
  std::vector<double> centers_, radii_;  // of the outer hulls, as the library takes them
  hgrid::Rows rows_;                     // borrowed: overlapping outer hulls
  std::vector<Slot> slots_;
  std::vector<int32_t> pool_;
  std::vector<int32_t> strays_;
  std::vector<char> is_stray_;
  std::vector<uint32_t> marks_;  // mark_: was a partner; mark_ + 1: still is
  uint32_t mark_ = 0;
  std::vector<int32_t> old_;  // the partners before a renewal
};

}  // namespace packing::event
