// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a grid must hold and answer, kept as a plain list and decided in exact arithmetic.
#pragma once

#include "oracle/pairs.hpp"

#include <cstdint>
#include <vector>

namespace fuzz {

class GridModel {
 public:
  explicit GridModel(const hg_grid_def &def);

  // Whether the grid may take these particles, and whether it must.
  bool may_take(const particles::ParticleSet &particles) const;
  bool must_take(const particles::ParticleSet &particles) const;

  void insert(const particles::ParticleSet &particles);
  void move(const std::vector<double> &centers, const std::vector<double> *radii);
  // False, and nothing happens, if an id is unknown or comes twice.
  bool remove(const std::vector<int32_t> &ids);
  void clear();

  size_t size() const { return ids_.size(); }
  const particles::ParticleSet &particles() const { return particles_; }
  const std::vector<int32_t> &ids() const { return ids_; }

  // `pairs` is what the accuracy of the grid promises.
  void check_pairs(oracle::Pairs pairs) const;
  // The same for the partners of a sphere.
  void check_sphere(const oracle::Sphere &sphere, const int32_t *ids, size_t count) const;

 private:
  enum class Promise { kExact, kDouble, kFloat, kSane };
  Promise promise(const particles::ParticleSet &particles) const;
  size_t row_of(int32_t id) const;

  hg_grid_def def_;
  particles::ParticleSet particles_;
  std::vector<int32_t> ids_;
  int32_t next_id_;
};

}  // namespace fuzz
