// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Jacobi sweeps: all pushes of one set of contacts are summed before any particle moves.
#include "packing/relaxation.hpp"

#include "packing/grid_def.hpp"
#include "particles/insert.hpp"

#include <algorithm>
#include <cmath>

namespace packing {
namespace {

// Share of an overlap that one sweep removes. A particle has several contacts, whose pushes add up: at 1 the sweeps
// overshoot and stop to converge.
constexpr double kPush = 0.6;
// The farthest a particle goes in one sweep, in its own radii: beyond that it could jump over a neighbour.
constexpr double kLongestStep = 0.3;

struct Contact {
  size_t i, j;
  double normal[3];  // unit vector from i to j
  double overlap;
};

Contact contact_of(const Box &box, const particles::ParticleSet &set, const hg_pair &pair) {
  const int d = box.dimension();
  Contact contact{static_cast<size_t>(pair.a), static_cast<size_t>(pair.b), {0, 0, 0}, 0};
  const double *x_i = &set.centers[contact.i * static_cast<size_t>(d)];
  const double *x_j = &set.centers[contact.j * static_cast<size_t>(d)];
  double square = 0;
  for (int axis = 0; axis < d; axis++) {
    contact.normal[axis] = box.nearest(axis, x_j[axis] - x_i[axis]);
    square += contact.normal[axis] * contact.normal[axis];
  }
  const double distance = std::sqrt(square);
  contact.overlap = set.radii[contact.i] + set.radii[contact.j] - distance;
  if (distance > 0) {
    for (int axis = 0; axis < d; axis++) contact.normal[axis] /= distance;
  } else {
    contact.normal[0] = 1;  // coincident centres part along x, the lower id to the left
  }
  return contact;
}

double mass(const particles::ParticleSet &set, size_t i) {
  const double r = set.radii[i];
  return set.dimension == 2 ? r * r : r * r * r;
}

// Adds the contact's push to both particles; the pushes leave their centre of mass where it is.
void add_push(const particles::ParticleSet &set, const Contact &contact, std::vector<double> &step) {
  const size_t d = static_cast<size_t>(set.dimension);
  const double m_i = mass(set, contact.i), m_j = mass(set, contact.j);
  const double length = kPush * contact.overlap / (m_i + m_j);
  for (size_t axis = 0; axis < d; axis++) {
    step[contact.i * d + axis] -= length * m_j * contact.normal[axis];
    step[contact.j * d + axis] += length * m_i * contact.normal[axis];
  }
}

void move(const Box &box, const std::vector<double> &steps, particles::ParticleSet &set) {
  const int d = box.dimension();
  for (size_t i = 0; i < set.count(); i++) {
    const double *step = &steps[i * static_cast<size_t>(d)];
    double *center = &set.centers[i * static_cast<size_t>(d)];
    double square = 0;
    for (int axis = 0; axis < d; axis++) square += step[axis] * step[axis];
    const double longest = kLongestStep * set.radii[i];
    const double scale = square > longest * longest ? longest / std::sqrt(square) : 1;
    for (int axis = 0; axis < d; axis++) center[axis] = box.keep(axis, center[axis] + scale * step[axis], set.radii[i]);
  }
}

// Of the contacts that a grid finds; each adds its push to `step` if that is given.
Overlaps overlaps_of(const Box &box, const particles::ParticleSet &set, hgrid::View<hg_pair> pairs,
                     std::vector<double> *step) {
  Overlaps found;
  for (const hg_pair &pair : pairs) {
    const Contact contact = contact_of(box, set, pair);
    const double relative = contact.overlap / std::min(set.radii[contact.i], set.radii[contact.j]);
    found.contacts++;
    found.mean += relative;
    found.largest = std::max(found.largest, relative);
    if (step != nullptr) add_push(set, contact, *step);
  }
  if (found.contacts > 0) found.mean /= static_cast<double>(found.contacts);
  return found;
}

}  // namespace

// The number of contacts that anybody counts who reads the packing.
Overlaps exact_overlaps(const particles::ParticleSet &set) {
  const Vector edge(set.box_max[0], set.box_max[1], set.box_max[2]);
  const Box box(set.dimension, edge, {set.periodic[0] != 0, set.periodic[1] != 0, set.periodic[2] != 0});
  hg_grid_def def = grid_def(box);
  def.accuracy = HG_EXACT;
  hgrid::Grid grid(def);
  particles::insert(set, grid);
  return overlaps_of(box, set, grid.query_pairs(), nullptr);
}

Overlaps relax(const Box &box, int sweeps, const SweepObserver &observe, particles::ParticleSet &set) {
  hgrid::Grid grid(grid_def(box));
  particles::insert(set, grid);
  std::vector<double> step(set.centers.size());
  for (int sweep = 0;; sweep++) {
    std::fill(step.begin(), step.end(), 0.0);
    const Overlaps found = overlaps_of(box, set, grid.query_pairs(), &step);
    if (observe) observe(sweep, found);
    if (sweep == sweeps || found.contacts == 0) return exact_overlaps(set);
    move(box, step, set);
    grid.move(set.count(), set.centers.data(), set.radii.data());
  }
}

}  // namespace packing
