// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Places for spheres (disks) of radius 1, and the shapes that arrangements are made of.
#pragma once

#include "packing/random.hpp"
#include "packing/vector.hpp"

#include <cstddef>
#include <vector>

namespace packing {

class Places {
 public:
  // `count` places are to be laid; what is filled is filled to `density`. `random` must outlive the places.
  Places(int dimension, size_t count, double density, Random &random);

  int dimension() const { return dimension_; }
  int last_axis() const { return dimension_ - 1; }
  size_t count() const { return count_; }
  size_t left() const { return count_ - centers_.size(); }  // to be laid
  size_t share(double of_all) const { return static_cast<size_t>(of_all * static_cast<double>(count_)); }
  Random &random() const { return *random_; }

  // The volume (area) that so many particles fill, and the edge of a cube (square) of it.
  double volume(double particles) const { return particles * volume_of_one_; }
  double edge(double particles) const;
  double edge_of_all() const { return edge(static_cast<double>(count_)); }
  // Between neighbours of a cubic lattice of the density; the edge of a cube of so many of its points, on whole layers.
  double spacing() const { return spacing_; }
  double lattice_edge(size_t particles) const;

  Vector draw_in_cube(double edge_of_cube) const;  // one corner at the origin
  Vector draw_direction() const;                   // a unit vector, all alike
  // Of radius 1 around the origin, on the first `axes` axes; the second: not so near the middle that it has no
  // direction.
  Vector draw_in_ball(int axes) const;
  Vector draw_off_middle(int axes) const;

  // What is laid beyond `count` is left out.
  void add(const Vector &center);

  // Shapes filled by a cubic lattice that is shaken a little. A cube of so many particles, with its lowest corner; its
  // last layer may be incomplete.
  void add_cube(size_t particles, const Vector &low);
  // A ball of about so many, one at least.
  void add_ball(size_t particles, const Vector &middle);
  // A cone along the last axis, from its tip up (`way` 1) or down (-1), `slope` high per radius. Returns its height.
  double add_cone(size_t particles, const Vector &tip, int way, double slope);

  // The box [0, edge] on each axis that the places are in, periodic; 0: none.
  void set_box(double edge) { box_edge_ = edge; }
  double box_edge() const { return box_edge_; }
  // All that are laid, in the order of laying.
  std::vector<Vector> &centers() { return centers_; }

 private:
  size_t points_along(size_t particles) const;
  Vector shaken(const Vector &place) const;

  int dimension_;
  size_t count_;
  double volume_of_one_, spacing_;
  Random *random_;
  double box_edge_ = 0;
  std::vector<Vector> centers_;
};

}  // namespace packing
