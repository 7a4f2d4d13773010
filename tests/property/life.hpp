// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A grid that lives through random calls, beside a plain list of what it must hold; after most of them it is asked, and
// its answers are compared with those of the oracle.
#pragma once

#include "tests/property/company_changes.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

namespace hgtest {

// Whether a particle is so many cells away, or is taken there on the way, that the grid may refuse it.
bool has_far_particles(const hg_grid_def &def, const Particles &particles);

double mean_radius(const Particles &particles);

class Life {
 public:
  // Begins with the particles of the scene. Those that come later have places and radii of them, and so fit the cells
  // of the user and the box at first. Of the calls, the share `box_changes` gives the grid another box, the share
  // `company_changes` other groups or bodies.
  Life(uint64_t seed, Scene scene, double box_changes, double company_changes);

  // Throws a text that says what differs.
  void run(int steps);

  hg_grid_stats stats() const { return grid_.get_stats(); }
  uint64_t compared() const { return compared_; }  // answers

 private:
  double length(int axis) const { return scene_.def.box_max[axis] - scene_.def.box_min[axis]; }
  size_t any_of_pool() { return rng_.below(scene_.particles.count()); }

  void insert();
  void move();
  void set();
  void remove();
  void clear();
  void change_box();
  hg_grid_def changed_box();

  // Makes the call, which must be taken if the grid may hold these particles in this box, else refused. Whether it was;
  // not made where particles are so far away that either is right.
  template <class Call>
  bool take(const char *what, const hg_grid_def &def, const Particles &particles, Call call);

  Pairs meeting_pairs() const;
  Pairs expected_pairs() const;
  size_t row_of(int32_t id) const;
  void compare();
  void compare_visit(const Pairs &expected);
  void compare_rows(const Pairs &expected);
  void compare_spheres();
  void compare_shapes();
  void require_answer(const char *what, const Pairs &got, const Pairs &expected);

  Rng rng_;
  Scene scene_;
  double box_changes_, company_changes_;
  double step_;  // of a particle, at most
  Particles live_;
  std::vector<int32_t> ids_;
  int32_t next_id_;
  Company company_;
  oracle::Rule *rule_;
  uint64_t compared_ = 0;
  Grid grid_;
};

}  // namespace hgtest
