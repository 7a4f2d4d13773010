// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/bench/peers/nanoflann_spheres.hpp"

#include <nanoflann.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>

namespace bench {
namespace {

// What nanoflann asks of its points.
struct Points {
  const std::vector<double> &x;

  size_t kdtree_get_point_count() const { return x.size() / 3; }
  double kdtree_get_pt(size_t i, size_t axis) const { return x[3 * i + axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box &) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 3, uint32_t>;

class Collect {
 public:
  Collect(double square, std::vector<uint32_t> &ids) : square_(square), ids_(&ids) {}
  size_t size() const { return ids_->size(); }
  bool full() const { return true; }
  double worstDist() const { return square_; }
  bool addPoint(double square, uint32_t index) {
    if (square < square_) ids_->push_back(index);
    return true;
  }

 private:
  double square_;
  std::vector<uint32_t> *ids_;
};

// A tree points to its points.
struct Forest {
  explicit Forest(const std::vector<double> &x) : points{x}, tree(3, points, {20}) {}
  Points points;
  Tree tree;
};

}  // namespace

std::function<size_t()> nanoflann_spheres(const std::vector<double> &points, double reach,
                                          const std::vector<double> &queries) {
  const auto forest = std::make_shared<Forest>(points);
  return [forest, reach, &queries, ids = std::vector<uint32_t>(), offsets = std::vector<size_t>()]() mutable {
    ids.clear();
    offsets.assign(1, 0);
    for (size_t k = 0; k < queries.size() / 3; k++) {
      Collect collect(reach * reach, ids);
      forest->tree.findNeighbors(collect, &queries[3 * k], nanoflann::SearchParams());
      std::sort(ids.begin() + static_cast<ptrdiff_t>(offsets.back()), ids.end());
      offsets.push_back(ids.size());
    }
    return ids.size();
  };
}

}  // namespace bench
