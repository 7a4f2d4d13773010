// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Bullet, btDbvt: a dynamic tree of boxes in floats, collided with itself.
#include "programs/bench/peers/peer.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <memory>

namespace bench {
namespace {

struct Collect : btDbvt::ICollide {
  Collect(const std::vector<Sphere> &all, std::vector<hg_pair> &found) : spheres(&all), pairs(&found) {}

  void Process(const btDbvtNode *a, const btDbvtNode *b) override {
    keep_if_overlapping(*spheres, a->dataAsInt, b->dataAsInt, *pairs);
  }

  const std::vector<Sphere> *spheres;
  std::vector<hg_pair> *pairs;
};

btDbvtVolume volume_of(const Sphere &s) {
  const btVector3 low(float_below(s.x[0] - s.r), float_below(s.x[1] - s.r), float_below(s.x[2] - s.r));
  const btVector3 high(float_above(s.x[0] + s.r), float_above(s.x[1] + s.r), float_above(s.x[2] + s.r));
  return btDbvtVolume::FromMM(low, high);
}

// The tree is built anew: by inserting one by one and, with `rebuild`, from the top down after that.
PairFinder finder(const Particles &particles, bool rebuild) {
  return [particles, rebuild, spheres = std::vector<Sphere>()](std::vector<hg_pair> &pairs) mutable {
    copy_spheres(particles, spheres);
    btDbvt tree;
    for (size_t i = 0; i < spheres.size(); i++) {
      btDbvtNode *leaf = tree.insert(volume_of(spheres[i]), nullptr);
      leaf->data = nullptr;  // the whole of the union
      leaf->dataAsInt = static_cast<int>(i);
    }
    if (rebuild) tree.optimizeTopDown();
    Collect collect(spheres, pairs);
    tree.collideTT(tree.m_root, tree.m_root, collect);
    tree.clear();
  };
}

}  // namespace

void add_bullet(std::vector<Peer> &peers) {
  for (const bool rebuild : {false, true}) {
    peers.push_back({"bullet", rebuild ? "top-down" : "inserted",
                     [rebuild](const Particles &particles) { return finder(particles, rebuild); }});
  }
}

}  // namespace bench
