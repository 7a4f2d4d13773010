// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// golden FILE: the hashes of all scenes, for 1 to 8 threads, must be those of the file.
// golden --record: prints such a file. Each set is first decided pair by pair by the oracle of the tests; only then is
// its hash, and that of its order, worth keeping.
#include "tests/golden/golden_scenes.hpp"
#include "tests/support/compare.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace {

using golden::GoldenScene;
using oracle::Pairs;

// FNV-1a of the bytes, least significant first whatever the machine.
class Hash {
 public:
  void add(uint64_t value, int bytes) {
    for (int k = 0; k < bytes; k++) state_ = (state_ ^ (value >> 8 * k & 0xff)) * 0x100000001b3u;
  }
  void add(double value) {
    uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof value);
    add(bits, 8);
  }
  uint64_t value() const { return state_; }

 private:
  uint64_t state_ = 0xcbf29ce484222325u;
};

uint64_t hash_of(const Pairs &pairs) {
  Hash hash;
  for (const hg_pair &pair : pairs) {
    hash.add(static_cast<uint32_t>(pair.a), 4);
    hash.add(static_cast<uint32_t>(pair.b), 4);
  }
  return hash.value();
}

uint64_t hash_of(const particles::ParticleSet &particles) {
  Hash hash;
  for (const double x : particles.centers) hash.add(x);
  for (const double r : particles.radii) hash.add(r);
  return hash.value();
}

Pairs search(GoldenScene &scene, int32_t order, int threads) {
  scene.def.pair_order = order;
  scene.def.thread_count = threads;
  return hgtest::pairs_of(hgtest::make_grid(scene.def, scene.particles));
}

std::string line_of(const GoldenScene &scene, const Pairs &by_id, const Pairs &as_found) {
  char hashes[96];
  std::snprintf(hashes, sizeof hashes, " %zu %016" PRIx64 " %016" PRIx64 " %016" PRIx64, by_id.size(),
                hash_of(scene.particles), hash_of(by_id), hash_of(as_found));
  return scene.name + hashes;
}

bool is_periodic(const hg_grid_def &def) { return def.periodic[0] + def.periodic[1] + def.periodic[2] > 0; }

Pairs expected_pairs(const GoldenScene &scene, oracle::Rule *rule) {
  return is_periodic(scene.def) ? all_pairs(scene.def, scene.particles, rule)
                                : swept_pairs(scene.def, scene.particles, rule);
}

// HG_FLOAT may have more than the exact pairs, but no fewer.
void require_justified(const GoldenScene &scene, const Pairs &by_id) {
  const bool plain = scene.def.accuracy == HG_DOUBLE;
  const Pairs expected = expected_pairs(scene, plain ? oracle::double_interact : oracle::exact_interact);
  if (scene.def.accuracy != HG_FLOAT) {
    hgtest::require_same(scene.name.c_str(), by_id, expected);
  } else {
    hgtest::require(std::includes(by_id.begin(), by_id.end(), expected.begin(), expected.end(), oracle::pair_less),
                    scene.name + ": a pair is missing");
  }
}

int record() {
  std::printf("scene pairs input by-id as-found\n");
  for (GoldenScene &scene : golden::all_scenes()) {
    const Pairs by_id = search(scene, HG_ORDER_ID, 1);
    require_justified(scene, by_id);
    std::printf("%s\n", line_of(scene, by_id, search(scene, HG_ORDER_GRID, 1)).c_str());
  }
  return 0;
}

int compare(const char *path) {
  std::ifstream file(path);
  std::string expected;
  std::getline(file, expected);
  int differ = file ? 0 : 1;
  for (GoldenScene &scene : golden::all_scenes()) {
    std::getline(file, expected);
    for (int threads = 1; threads <= 8; threads++) {
      const std::string found =
          line_of(scene, search(scene, HG_ORDER_ID, threads), search(scene, HG_ORDER_GRID, threads));
      if (file && found == expected) continue;
      std::fprintf(stderr, "%d threads\n  found    %s\n  expected %s\n", threads, found.c_str(), expected.c_str());
      differ++;
    }
  }
  std::printf("%d results differ from %s\n", differ, path);
  return differ == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char **arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: golden FILE | --record\n");
    return 2;
  }
  try {
    return std::strcmp(arguments[1], "--record") == 0 ? record() : compare(arguments[1]);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "golden: %s\n", error.what());
    return 1;
  }
}
