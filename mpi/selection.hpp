// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which of its particles a rank sends to which other: each, whatever the number of periods, once to each rank that has
// a smaller one in its reach. Most lie deeper inside than they reach, and are done with after one look at all ranks.
#pragma once

#include "mpi/size_boxes.hpp"

namespace hgrid::mpi {

// What all ranks have told: the boxes of rank k are at begin[k] .. begin[k + 1] - 1.
struct BoxesOfRanks {
  std::vector<SizeBox> boxes;
  std::vector<size_t> begin;

  size_t rank_count() const { return begin.size() - 1; }
};

class Selection {
 public:
  // All must outlive this, which keeps radii but no centres.
  Selection(const ReachRule &rule, size_t count, const double *centers, const double *radii)
      : rule_(rule),
        radii_(radii),
        own_(make_size_classes(rule.cell(), count, centers, radii)),
        whole_(box_around(own_.boxes.data(), own_.boxes.size())) {}

  // What other ranks are told.
  const std::vector<SizeBox> &boxes() const { return own_.boxes; }
  // For each rank the rows, ascending, of those that may meet, as the larger of two, one of its particles. None for
  // `own`, the rank that owns these.
  std::vector<std::vector<int32_t>> rows_for(const BoxesOfRanks &ranks, size_t own) const;

 private:
  // A box of theirs at one of its images; radii may reach so much farther as rounding asks for.
  struct Target {
    double low[3], high[3];
    double smallest, largest, slack;
  };
  // What one of our classes sees of a rank at one image: what is in the reach of its largest, and a box around all
  // places from where that is so.
  struct View {
    size_t rank;
    double n[3];
    double low[3], high[3];
    std::vector<Target> targets;
  };
  class Lookup;

  bool may_meet(const SizeBox &theirs, const SizeBox &own) const;
  void add_views(const SizeBox &theirs, const SizeBox &own, size_t rank, std::vector<View> &views) const;
  bool may_meet(const Target &target, const double *place, double radius) const;
  bool may_meet(const View &view, size_t row) const;

  const ReachRule &rule_;
  const double *radii_;
  SizeClasses own_;
  SizeBox whole_;
};

}  // namespace hgrid::mpi
