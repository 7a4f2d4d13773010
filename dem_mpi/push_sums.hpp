// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What contacts do to particles, added up without rounding: the sums do not depend on the order of the contacts, nor on
// which ranks find them.
//
// Each force is cut into a multiple of a quantum and a rest, the rest rounded to a multiple of a far smaller quantum.
// Sums of multiples are exact as long as they stay below 2^53 of them. The quanta come from what a contact that is as
// deep as the largest particle would bear: they reach a million times higher, and 2^-70 of it is the last bit.
#pragma once

#include "dem/base/large_array.hpp"
#include "dem/state/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dem::ranks {

class PushSums {
 public:
  // `force`: of that contact; `arm`: the largest radius; with torques if particles rotate.
  PushSums(double force, double arm, bool rotating);

  // Nothing acts on any of `count` particles; on those from `first` on.
  void clear(size_t count) { sums_.assign(rows_ * count, Row<double>{}); }
  void clear_from(size_t first) {
    std::fill(sums_.begin() + static_cast<ptrdiff_t>(rows_ * first), sums_.end(), Row<double>{});
  }

  void add(size_t particle, const Course<double> &move, const Course<double> *turn) {
    Row<double> *sums = &sums_[rows_ * particle];
    double size = force_.add(move.push, sums);
    if (turn != nullptr) size += torque_.add(turn->push, sums + 2) * inverse_arm_;
    sums[0].numbers[3] += size + least_weight_;
  }

  // The sums of a particle as so many doubles, for those who add them up over ranks.
  size_t columns() const { return 4 * rows_; }
  double *of(size_t particle) { return sums_.empty() ? nullptr : (sums_.data() + rows_ * particle)->numbers; }

  // Adds what has come together; nothing acts then any more. False if it may not be exact: forces are too large, or
  // none.
  bool give(size_t particle, Course<double> &move, Course<double> *turn) {
    Row<double> *sums = &sums_[rows_ * particle];
    const double weight = sums[0].numbers[3];
    if (weight == 0) return true;
    for (int k = 0; k < 3; k++) move.push.numbers[k] += sums[0].numbers[k] + sums[1].numbers[k];
    for (int k = 0; k < 3 && turn != nullptr; k++) turn->push.numbers[k] += sums[2].numbers[k] + sums[3].numbers[k];
    for (size_t row = 0; row < rows_; row++) sums[row] = {};
    return weight < most_weight_;
  }

  // The largest sum of forces that is exact.
  double most() const { return most_weight_; }

 private:
  using Four = Row<double>::Four;

  // Multiples of two quanta. Of numbers as large as the shifts the last bit is the quantum.
  struct Quanta {
    double shift, fine_shift;

    explicit Quanta(double quantum) : shift(0x1.8p52 * quantum), fine_shift(0x1.8p52 * kFiner * quantum) {}

    // Returns a number that is not below any component, in size; none if one is none.
    double add(Row<double> push, Row<double> *sums) const {
      const Four all = push.four(), coarse = (all + shift) - shift, rest = all - coarse;
      sums[0].four() += coarse;
      sums[1].four() += (rest + fine_shift) - fine_shift;
      return std::abs(coarse[0]) + std::abs(coarse[1]) + std::abs(coarse[2]);
    }
  };

  // Of 2^15 contacts the rests, up to half a quantum each, add up to 2^52 fine quanta.
  static constexpr double kFiner = 0x1p-38, kMostContacts = 0x1p15;

  size_t rows_;  // of a particle: forces and their rests, torques and theirs; the weight stands beside the forces
  double inverse_arm_, most_weight_, least_weight_;
  Quanta force_, torque_;
  LargeArray<Row<double>> sums_;
};

}  // namespace dem::ranks
