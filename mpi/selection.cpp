// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/selection.hpp"

#include <algorithm>
#include <limits>

namespace hgrid::mpi {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

// The views of one class by place: along each axis the box of the class is cut into bins, and each bin has a bit for
// each view that reaches into it. A place is seen at most by those whose bits all its three bins have.
class Selection::Lookup {
 public:
  Lookup(const SizeBox &own, const std::vector<View> &views) : words_((views.size() + 63) / 64) {
    for (size_t axis = 0; axis < 3; axis++) {
      low_[axis] = own.box.low[axis];
      const double extent = own.box.high[axis] - own.box.low[axis];
      per_bin_[axis] = extent > 0 && extent < kInfinity ? kBins / extent : 0;
      bits_[axis].assign(kBins * words_, 0);
      for (size_t k = 0; k < views.size(); k++) {
        // bin() never decreases: what lies in between is in bins in between.
        const size_t last = bin(axis, views[k].high[axis]);
        for (size_t here = bin(axis, views[k].low[axis]); here <= last; here++) {
          bits_[axis][here * words_ + k / 64] |= uint64_t{1} << k % 64;
        }
      }
    }
  }

  // Calls of(k) for each view that may reach the place.
  template <class Of>
  void for_views(const double *place, Of &&of) const {
    const uint64_t *x = bits_[0].data() + bin(0, place[0]) * words_;
    const uint64_t *y = bits_[1].data() + bin(1, place[1]) * words_;
    const uint64_t *z = bits_[2].data() + bin(2, place[2]) * words_;
    for (size_t word = 0; word < words_; word++) {
      uint64_t bits = x[word] & y[word] & z[word];
      for (size_t k = 64 * word; bits != 0; k++, bits >>= 1) {
        if ((bits & 1) != 0) of(k);
      }
    }
  }

 private:
  static constexpr size_t kBins = 64;

  size_t bin(size_t axis, double x) const {
    const double bins = (x - low_[axis]) * per_bin_[axis];
    // Not a number only if all places are in one bin.
    if (!(bins > 0)) return 0;
    return bins < kBins ? static_cast<size_t>(bins) : kBins - 1;
  }

  size_t words_;
  double low_[3], per_bin_[3];
  std::vector<uint64_t> bits_[3];  // [kBins][words_]
};

bool Selection::may_meet(const SizeBox &theirs, const SizeBox &own) const {
  if (!(theirs.smallest <= own.largest)) return false;
  const double reach = rule_.reach(own.largest, std::min(own.largest, theirs.largest));
  const double slack = rule_.cell().slack(theirs.box, own.box, reach);
  bool any = false;
  const auto found = [&](const double * /*n*/, const double * /*offset*/) { any = true; };
  return !rule_.cell().for_images(theirs.box, own.box, reach + slack, found) || any;
}

void Selection::add_views(const SizeBox &theirs, const SizeBox &own, size_t rank, std::vector<View> &views) const {
  if (theirs.smallest > own.largest) return;
  double reach = rule_.reach(own.largest, std::min(own.largest, theirs.largest));
  const double slack = rule_.cell().slack(theirs.box, own.box, reach);
  reach += slack;
  const auto add = [&](const double *n, const Target &target) {
    // The views of one rank follow each other.
    auto view = std::find_if(views.rbegin(), views.rend(), [&](const View &other) {
                  return other.rank != rank || std::equal(n, n + 3, other.n);
                }).base();
    if (view == views.begin() || (view - 1)->rank != rank) {
      const View nothing{
          rank, {n[0], n[1], n[2]}, {kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}, {}};
      views.push_back(nothing);
      view = views.end();
    }
    --view;
    for (size_t axis = 0; axis < 3; axis++) {
      view->low[axis] = std::min(view->low[axis], target.low[axis] - reach);
      view->high[axis] = std::max(view->high[axis], target.high[axis] + reach);
    }
    view->targets.push_back(target);
  };
  Target target{{0, 0, 0}, {0, 0, 0}, theirs.smallest, theirs.largest, slack};
  const bool all = rule_.cell().for_images(theirs.box, own.box, reach, [&](const double *n, const double *offset) {
    for (size_t axis = 0; axis < 3; axis++) {
      target.low[axis] = theirs.box.low[axis] + offset[axis];
      target.high[axis] = theirs.box.high[axis] + offset[axis];
    }
    add(n, target);
  });
  if (all) return;
  // Reached from everywhere.
  const double none[3] = {0, 0, 0};
  std::fill_n(target.low, 3, -kInfinity);
  std::fill_n(target.high, 3, kInfinity);
  add(none, target);
}

bool Selection::may_meet(const Target &target, const double *place, double radius) const {
  if (target.smallest > radius) return false;
  const double reach = rule_.reach(radius, std::min(radius, target.largest)) + target.slack;
  // What the squares of the gaps may still sum up to, in squares of the reach: so they neither overflow nor vanish.
  double rest = 1 + 0x1p-46;
  for (size_t axis = 0; axis < 3; axis++) {
    const double gap = std::max(target.low[axis] - place[axis], place[axis] - target.high[axis]);
    if (!(gap > 0)) continue;
    if (gap > reach) return false;
    rest -= gap / reach * (gap / reach);
  }
  return !(rest < 0);
}

bool Selection::may_meet(const View &view, size_t row) const {
  const double *place = &own_.places[3 * row];
  for (size_t axis = 0; axis < 3; axis++) {
    if (place[axis] < view.low[axis] || place[axis] > view.high[axis]) return false;
  }
  return std::any_of(view.targets.begin(), view.targets.end(),
                     [&](const Target &target) { return may_meet(target, place, radii_[row]); });
}

std::vector<std::vector<int32_t>> Selection::rows_for(const BoxesOfRanks &ranks, size_t own) const {
  std::vector<std::vector<int32_t>> rows(ranks.rank_count());
  std::vector<std::vector<View>> views(own_.boxes.size());  // of each class
  for (size_t rank = 0; rank < rows.size(); rank++) {
    const SizeBox *const theirs = ranks.boxes.data() + ranks.begin[rank];
    const size_t count = ranks.begin[rank + 1] - ranks.begin[rank];
    // Most ranks are far away.
    if (rank == own || !may_meet(box_around(theirs, count), whole_)) continue;
    for (size_t k = 0; k < views.size(); k++) {
      for (size_t other = 0; other < count; other++) add_views(theirs[other], own_.boxes[k], rank, views[k]);
    }
  }
  std::vector<Lookup> lookups;
  for (size_t k = 0; k < views.size(); k++) lookups.emplace_back(own_.boxes[k], views[k]);
  for (size_t row = 0; row < own_.class_of.size(); row++) {
    const std::vector<View> &seen = views[own_.class_of[row]];
    lookups[own_.class_of[row]].for_views(&own_.places[3 * row], [&](size_t k) {
      std::vector<int32_t> &chosen = rows[seen[k].rank];
      const auto number = static_cast<int32_t>(row);
      if ((chosen.empty() || chosen.back() != number) && may_meet(seen[k], row)) chosen.push_back(number);
    });
  }
  return rows;
}

}  // namespace hgrid::mpi
