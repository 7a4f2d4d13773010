// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// nanoflann: one k-d tree of centres for each class of sizes; each particle looks into its own and all finer classes.
#include "programs/bench/peers/peer.hpp"

#include <nanoflann.hpp>

#include <cstdlib>
#include <memory>

namespace bench {
namespace {

struct SizeClass {
  double largest = 0;  // radius
  std::vector<int32_t> members;
  std::vector<Sphere> spheres;  // of the members

  // What nanoflann asks of its points.
  size_t kdtree_get_point_count() const { return spheres.size(); }
  double kdtree_get_pt(size_t i, size_t axis) const { return spheres[i].x[axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box &) const {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, SizeClass>, SizeClass, 3, uint32_t>;

// Receives the points within the radius of the search and keeps those whose spheres overlap.
class Collect {
 public:
  Collect(const Sphere &sphere, int32_t id, const SizeClass &others, bool own_class, std::vector<hg_pair> &pairs)
      : sphere_(&sphere), id_(id), others_(&others), own_class_(own_class), pairs_(&pairs) {
    const double reach = sphere.r + others.largest;
    square_ = reach * reach * (1 + 1e-12);  // the tree's own sums are rounded
  }
  size_t size() const { return 0; }
  bool full() const { return true; }
  double worstDist() const { return square_; }
  bool addPoint(double, uint32_t index) {
    const int32_t other = others_->members[index];
    const bool seen_from_other = own_class_ && other <= id_;
    if (!seen_from_other && overlap(*sphere_, others_->spheres[index])) {
      pairs_->push_back({std::min(id_, other), std::max(id_, other)});
    }
    return true;
  }

 private:
  const Sphere *sphere_;
  int32_t id_;
  const SizeClass *others_;
  bool own_class_;
  std::vector<hg_pair> *pairs_;
  double square_;
};

// Classes of radii from R / ratio to R, the coarsest first.
std::vector<SizeClass> classes_of(const Particles &particles, double ratio) {
  std::vector<SizeClass> classes;
  if (particles.count == 0) return classes;
  const double largest = *std::max_element(particles.radii, particles.radii + particles.count);
  const double smallest = *std::min_element(particles.radii, particles.radii + particles.count);
  std::vector<double> limits;  // descending upper limits
  for (double limit = largest; limits.empty() || limit >= smallest; limit /= ratio) limits.push_back(limit);
  classes.resize(limits.size());
  for (size_t i = 0; i < particles.count; i++) {
    const double r = particles.radii[i];
    // The last limit that is no smaller than r.
    const auto below = std::partition_point(limits.begin(), limits.end(), [r](double limit) { return limit >= r; });
    SizeClass &own = classes[static_cast<size_t>(below - limits.begin()) - 1];
    const double *c = particles.centers + 3 * i;
    own.largest = std::max(own.largest, r);
    own.members.push_back(static_cast<int32_t>(i));
    own.spheres.push_back({{c[0], c[1], c[2]}, r});
  }
  return classes;
}

PairFinder finder(const Particles &particles, double ratio, size_t leaf) {
  return [=](std::vector<hg_pair> &pairs) {
    const std::vector<SizeClass> classes = classes_of(particles, ratio);
    std::vector<std::unique_ptr<Tree>> trees;
    for (const SizeClass &c : classes) {
      trees.push_back(std::make_unique<Tree>(3, c, nanoflann::KDTreeSingleIndexAdaptorParams(leaf)));
    }
    for (size_t h = 0; h < classes.size(); h++) {
      for (size_t finer = h; finer < classes.size(); finer++) {
        if (classes[finer].members.empty()) continue;
        // In the order of the own tree, so that near particles search one after the other.
        for (const uint32_t i : trees[h]->vAcc) {
          const Sphere &sphere = classes[h].spheres[i];
          Collect collect(sphere, classes[h].members[i], classes[finer], finer == h, pairs);
          trees[finer]->findNeighbors(collect, sphere.x, nanoflann::SearchParams());
        }
      }
    }
  };
}

}  // namespace

void add_nanoflann(std::vector<Peer> &peers) {
  for (const char *ratio : {"1.5", "2", "3"}) {
    for (const int leaf : {20, 40}) {
      const auto prepare = [ratio = std::strtod(ratio, nullptr), leaf](const Particles &particles) {
        return finder(particles, ratio, static_cast<size_t>(leaf));
      };
      peers.push_back({"nanoflann", std::string("ratio-") + ratio + "-leaf-" + std::to_string(leaf), prepare});
    }
  }
}

}  // namespace bench
