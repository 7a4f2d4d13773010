// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// CGAL, box_self_intersection_d: hybrid of streamed segment trees and, below `cutoff` boxes, sweeps.
#include "programs/bench/peers/peer.hpp"

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/box_intersection_d.h>

#include <memory>
#include <utility>

namespace bench {
namespace {

// A box that knows its particle; CGAL orders boxes of equal coordinates by the number.
using Box = CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_EXPLICIT>;

class NumberedBox : public Box {
 public:
  NumberedBox(double low[3], double high[3], int32_t number) : Box(low, high), number_(number) {}
  size_t id() const { return static_cast<size_t>(number_); }
  int32_t number() const { return number_; }

 private:
  int32_t number_;
};

class Finder {
 public:
  Finder(const Particles &particles, ptrdiff_t cutoff) : particles_(particles), cutoff_(cutoff) {}

  void operator()(std::vector<hg_pair> &pairs) {
    copy_spheres(particles_, spheres_);
    boxes_.clear();
    handles_.clear();
    boxes_.reserve(spheres_.size());
    for (const Sphere &s : spheres_) {
      double low[3], high[3];
      for (int k = 0; k < 3; k++) {
        // One step outwards: the rounded ends may have moved inwards.
        low[k] = std::nextafter(s.x[k] - s.r, -std::numeric_limits<double>::infinity());
        high[k] = std::nextafter(s.x[k] + s.r, std::numeric_limits<double>::infinity());
      }
      boxes_.emplace_back(low, high, static_cast<int32_t>(boxes_.size()));
    }
    // CGAL moves its elements about a lot: pointers are cheaper than boxes.
    for (const NumberedBox &box : boxes_) handles_.push_back(&box);
    CGAL::box_self_intersection_d(
        handles_.begin(), handles_.end(),
        [&](const NumberedBox *a, const NumberedBox *b) {
          keep_if_overlapping(spheres_, a->number(), b->number(), pairs);
        },
        cutoff_);
  }

 private:
  Particles particles_;
  ptrdiff_t cutoff_;
  std::vector<Sphere> spheres_;
  std::vector<NumberedBox> boxes_;
  std::vector<const NumberedBox *> handles_;
};

}  // namespace

void add_cgal(std::vector<Peer> &peers) {
  for (const int cutoff : {300, 1000, 2000, 3000, 5000, 10000}) {
    peers.push_back({"cgal", "cutoff-" + std::to_string(cutoff), [cutoff](const Particles &particles) {
                       auto finder = std::make_shared<Finder>(particles, cutoff);
                       return [finder](std::vector<hg_pair> &pairs) { (*finder)(pairs); };
                     }});
  }
}

}  // namespace bench
