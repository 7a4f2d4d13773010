// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Inner and outer hulls, their lists of partners, and the library's grid that holds the outer ones.
#include "packing/event/hull_lists.hpp"

#include <algorithm>
#include <cmath>

namespace packing::event {
namespace {

// A particle whose outer hull leaves less than this share of the skin is a stray.
constexpr double kLeastSkin = 0.5;

hgrid::Grid outer_grid(const Box &box) {
  hg_grid_def def = hg_default_grid_def();
  box.describe(def);
  def.thread_count = 1;     // rebuilding is a small part; waiting threads would take a core from others
  def.accuracy = HG_FLOAT;  // lists may hold a pair too much, never one too few
  return hgrid::Grid(def);
}

}  // namespace

HullLists::HullLists(const Box &box, size_t count)
    : box_(box),
      grid_(outer_grid(box)),
      outer_(count),
      inner_(count),
      centers_(count * static_cast<size_t>(box.dimension())),
      radii_(count),
      slots_(count),
      is_stray_(count, 0),
      marks_(count, 0) {}

void HullLists::rebuild(const std::vector<Sphere> &spheres, const std::vector<double> &inner,
                        const std::vector<double> &outer) {
  const size_t d = static_cast<size_t>(box_.dimension());
  for (size_t i = 0; i < spheres.size(); i++) {
    inner_[i] = {spheres[i].center, spheres[i].radius + inner[i]};
    outer_[i] = {spheres[i].center, spheres[i].radius + outer[i]};
    for (size_t axis = 0; axis < d; axis++) centers_[i * d + axis] = spheres[i].center[static_cast<Eigen::Index>(axis)];
    radii_[i] = outer_[i].radius;
  }
  if (filled_) {
    grid_.move(spheres.size(), centers_.data(), radii_.data());
  } else {
    grid_.insert(spheres.size(), centers_.data(), radii_.data());
    filled_ = true;
  }
  rows_ = grid_.query_neighbors(HG_FULL);
  for (const int32_t stray : strays_) is_stray_[index(stray)] = 0;
  strays_.clear();
  std::fill(marks_.begin(), marks_.end(), 0u);
  mark_ = 0;
  fill_rows();
}

void HullLists::fill_rows() {
  pool_.clear();
  for (size_t i = 0; i < inner_.size(); i++) {
    Slot &slot = slots_[i];
    slot.begin = pool_.size();
    for (const int32_t j : rows_[i]) {
      if (overlap(inner_[i], inner_[index(j)])) pool_.push_back(j);
    }
    slot.count = static_cast<uint32_t>(pool_.size() - slot.begin);
    slot.capacity = slot.count + slot.count / 4 + 2;
    pool_.resize(slot.begin + slot.capacity);
  }
}

// Sets the inner hull. False if the particle has just become a stray or was one before.
bool HullLists::fit_in_outer(int32_t particle, const Sphere &sphere, double skin) {
  Sphere &hull = inner_[index(particle)];
  hull = {sphere.center, sphere.radius + skin};
  if (is_stray_[index(particle)] != 0) return false;
  const Sphere &outer = outer_[index(particle)];
  const double room = outer.radius - std::sqrt(square(box_.nearest(sphere.center - outer.center)));
  if (room >= hull.radius) return true;
  if (room - sphere.radius >= kLeastSkin * skin) {
    hull.radius = room;
    return true;
  }
  is_stray_[index(particle)] = 1;
  strays_.push_back(particle);
  return false;
}

// Calls visit(j) for all other particles whose inner hull may overlap this one's; strays perhaps twice.
template <class Visit>
void HullLists::visit_candidates(int32_t particle, Visit visit) {
  if (is_stray_[index(particle)] == 0) {
    for (const int32_t j : rows_[index(particle)]) visit(j);
  } else {
    const Sphere &hull = inner_[index(particle)];
    for (const int32_t j : grid_.query_sphere(hull.center.data(), hull.radius)) {
      if (j != particle) visit(j);
    }
  }
  for (const int32_t stray : strays_) {
    if (stray != particle) visit(stray);
  }
}

size_t HullLists::renew(int32_t particle, const Sphere &sphere, double skin) {
  fit_in_outer(particle, sphere, skin);
  mark_ += 2;
  const Row before = partners(particle);
  old_.assign(before.begin(), before.end());
  for (const int32_t j : old_) marks_[index(j)] = mark_;
  slots_[index(particle)].count = 0;
  const Sphere hull = inner_[index(particle)];
  size_t tested = 0;
  visit_candidates(particle, [&](int32_t j) {
    tested++;
    uint32_t &mark = marks_[index(j)];
    if (mark == mark_ + 1 || !overlap(hull, inner_[index(j)])) return;
    if (mark != mark_) append(j, particle);
    mark = mark_ + 1;
    append(particle, j);
  });
  for (const int32_t j : old_) {
    if (marks_[index(j)] == mark_) erase(j, particle);
  }
  return tested;
}

void HullLists::append(int32_t row, int32_t particle) {
  Slot &slot = slots_[index(row)];
  if (slot.count == slot.capacity) {
    // The old place is lost until the next rebuild, which packs all rows anew.
    const size_t begin = pool_.size();
    const uint32_t capacity = 2 * slot.capacity;
    pool_.resize(begin + capacity);
    std::copy_n(pool_.begin() + static_cast<ptrdiff_t>(slot.begin), slot.count,
                pool_.begin() + static_cast<ptrdiff_t>(begin));
    slot.begin = begin;
    slot.capacity = capacity;
  }
  pool_[slot.begin + slot.count++] = particle;
}

void HullLists::erase(int32_t row, int32_t particle) {
  Slot &slot = slots_[index(row)];
  int32_t *first = pool_.data() + slot.begin, *last = first + slot.count;
  *std::find(first, last, particle) = *(last - 1);
  --slot.count;
}

}  // namespace packing::event
