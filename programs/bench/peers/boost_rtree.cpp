// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Boost.Geometry, rtree: loaded in bulk, then one query for each particle.
#include "programs/bench/peers/peer.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <utility>

namespace bench {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Point>;
using Value = std::pair<Box, int32_t>;

Box box_of(const Sphere &s) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // One step outwards: the rounded ends may have moved inwards.
  const auto low = [&](int k) { return std::nextafter(s.x[k] - s.r, -kInfinity); };
  const auto high = [&](int k) { return std::nextafter(s.x[k] + s.r, kInfinity); };
  return Box(Point(low(0), low(1), low(2)), Point(high(0), high(1), high(2)));
}

// The tree is walked in its own order, so that one query finds in the cache what the last one left there.
template <size_t kNodeSize>
PairFinder finder(const Particles &particles) {
  return
      [particles, spheres = std::vector<Sphere>(), values = std::vector<Value>()](std::vector<hg_pair> &pairs) mutable {
        copy_spheres(particles, spheres);
        values.clear();
        for (const Sphere &s : spheres) values.emplace_back(box_of(s), static_cast<int32_t>(values.size()));
        const bgi::rtree<Value, bgi::linear<kNodeSize>> tree(values);  // how nodes split matters to single inserts only
        for (const Value &value : tree) {
          const int32_t a = value.second;
          const auto take = [&, a](const Value &other) {
            if (a < other.second) keep_if_overlapping(spheres, a, other.second, pairs);
          };
          tree.query(bgi::intersects(value.first), boost::make_function_output_iterator(take));
        }
      };
}

template <size_t kNodeSize>
void add(std::vector<Peer> &peers) {
  peers.push_back({"boost-rtree", "node-" + std::to_string(kNodeSize), finder<kNodeSize>});
}

}  // namespace

void add_boost_rtree(std::vector<Peer> &peers) {
  add<3>(peers);
  add<4>(peers);
  add<8>(peers);
}

}  // namespace bench
