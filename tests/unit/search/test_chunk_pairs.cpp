// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search of levels in chunks against the oracle: each task sends its pairs, chunks that particles search together
// or alone, many of them near one particle, images.
#include "tests/unit/uneven_crowd.hpp"

namespace {

using namespace hgtest;

bool check_crowd(uint64_t seed, size_t count) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  const hg::Domain domain = any_box(rng);
  const hg::Interaction interaction{rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE, rng.chance(0.7) ? 0.0 : 0.01};
  const Crowd crowd(memory, domain, interaction, rng.chance(0.8) ? 0.0 : 0.1,
                    uneven_particles(rng, domain, count, 1e-3), rng.uniform(2, 20));
  check_tasks(crowd, rng.below(4));
  return crowd.index.chunked && !crowd.index.chunks.has_giants();
}

void any_crowds(void **) {
  int chunked = 0;
  assert_true(sweep(300, [&](uint64_t seed) { chunked += check_crowd(seed, 1 + Rng(seed).below(400)) ? 1 : 0; }));
  assert_true(chunked > 60);
}

// One ball in a thin cloud of dust that has a dense core: more chunks near it than are listed at once.
void check_cloud(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  hg::Domain domain = any_box(rng);
  const Particles particles = ball_in_dust(rng, domain.dimension, 3000, 24, 0.1, 0.02);
  const Crowd crowd(memory, domain, {}, 0, particles, 9.9);
  require(crowd.index.chunked && crowd.index.chunks.chunks() > size_t{4} * hg::NearChunks::kMost, "%zu chunks",
          crowd.index.chunks.chunks());
  check_tasks(crowd, rng.below(4));
}

void many_chunks_near_one(void **) { assert_true(sweep(6, check_cloud)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_crowds), cmocka_unit_test(many_chunks_near_one)};
  return cmocka_run_group_tests_name("chunk_pairs", tests, nullptr, nullptr);
}
