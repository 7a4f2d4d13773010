// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The places of a layer against a plain list of those that hold a chunk; emptied and filled again, longer or shorter.
#include "src/index/chunk_plane.hpp"
#include "tests/unit/checks.hpp"

#include <vector>

namespace {

using namespace hgtest;

void check_layer(Rng &rng, hg::ChunkPlane &plane) {
  const size_t places = 3 + rng.below(rng.chance(0.3) ? 3000 : 60);
  const double share = rng.uniform();
  const auto first_chunk = static_cast<uint32_t>(rng.below(1000));
  plane.require(places);
  std::vector<uint32_t> chunk(places, 0);
  std::vector<size_t> held;
  for (size_t place = 0; place < places; place++) {
    if (!rng.chance(share)) continue;
    chunk[place] = first_chunk + static_cast<uint32_t>(held.size());
    plane.add(place, chunk[place]);
    held.push_back(place);
  }
  std::vector<bool> holds(places, false);
  for (const size_t place : held) holds[place] = true;
  for (size_t place = 0; place + 3 <= places; place++) {
    const hg::ChunkPlane::Three three = plane.three_from(place);
    for (size_t n = 3; n-- > 0;) {
      require((three.exist >> n & 1u) == (holds[place + n] ? 1u : 0u), "place %zu of %zu", place + n, places);
      if (holds[place + n] && (three.exist & ((1u << n) - 1)) == 0) {
        require(three.first == chunk[place + n], "chunk %u instead of %u", three.first, chunk[place + n]);
      }
    }
  }
  for (const size_t place : held) plane.remove(place);
}

void places_of_layers(void **) {
  assert_true(sweep(50, [](uint64_t seed) {
    Rng rng(seed);
    hg::Memory memory(hg::system_allocator());
    hg::ChunkPlane plane(memory);
    for (int n = 0; n < 6; n++) check_layer(rng, plane);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(places_of_layers)};
  return cmocka_run_group_tests_name("chunk_plane", tests, nullptr, nullptr);
}
