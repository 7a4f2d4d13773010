// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a grid must hold and answer, kept as a plain list and decided in exact arithmetic.
#pragma once

#include "oracle/pairs.hpp"
#include "tests/support/company.hpp"

#include <cstdint>
#include <vector>

namespace fuzz {

class GridModel {
 public:
  explicit GridModel(const hg_grid_def &def);

  // Whether a grid of this definition may hold these particles and no others, and whether it must.
  static bool may_hold(const hg_grid_def &def, const particles::ParticleSet &particles);
  static bool must_hold(const hg_grid_def &def, const particles::ParticleSet &particles);

  // Those that it holds, and more.
  particles::ParticleSet particles_and(const particles::ParticleSet &more) const;

  void insert(const particles::ParticleSet &particles);
  // These alone, with ids that start anew.
  void set(const particles::ParticleSet &particles);
  void move(const std::vector<double> &centers, const std::vector<double> *radii);
  // False, and nothing happens, if an id is unknown or comes twice.
  bool remove(const std::vector<int32_t> &ids);
  void clear();
  void set_definition(const hg_grid_def &def) { def_ = def; }

  size_t size() const { return ids_.size(); }
  const particles::ParticleSet &particles() const { return particles_; }
  const std::vector<int32_t> &ids() const { return ids_; }
  hgtest::Company &company() { return company_; }

  // Whether the oracle can look at all images of these particles, and the sphere, in little time.
  bool can_check(const particles::ParticleSet &particles) const;
  // `pairs` is what the accuracy of the grid promises.
  void check_pairs(oracle::Pairs pairs) const;
  // The same for the partners of a sphere.
  void check_sphere(const oracle::Sphere &sphere, const int32_t *ids, size_t count) const;
  // And those that meet shapes, in a cell that is not tilted.
  void check_box(const double *low, const double *high, const std::vector<int32_t> &ids) const;
  void check_triangle(const double *corners, const std::vector<int32_t> &ids) const;

 private:
  enum class Promise { kExact, kDouble, kFloat, kSane };
  Promise promise(const particles::ParticleSet &particles) const;
  size_t row_of(int32_t id) const;
  void check_row(const std::vector<int32_t> &ids) const;
  oracle::Pairs expected_pairs(oracle::Rule *rule) const;

  hg_grid_def def_;
  particles::ParticleSet particles_;
  std::vector<int32_t> ids_;
  int32_t next_id_;
  hgtest::Company company_;
};

}  // namespace fuzz
