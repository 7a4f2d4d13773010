// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The filter kernels of every instruction set that this machine runs against a plain loop over the candidates: any
// number of them, nearly touching or far apart, with pairs that the judge takes out and outputs that stop.
#include "tests/unit/kernels/kernel_sets.hpp"
#include "tests/unit/kernels/plain_test.hpp"
#include "tests/unit/kernels/recorder.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;

constexpr size_t kFewPieces = size_t{4} * hg::kMaxPiece;

bool is_odd(const hg::UndecidedPair &pair) { return (pair.a + 3 * pair.b) % 2 == 1; }

class Scene {
 public:
  Scene(uint64_t seed, size_t count) : rng_(seed), interaction_(rng_.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE) {
    rules_.id_offset = rng_.integer(0, 1);
    rules_.written = [this](const hg::UndecidedPair &pair) { return slots_of(pair.a, pair.b); };
    make_points();
    for (size_t k = 0; k < count; k++) {
      // Searches leave the candidates of one point together.
      const bool new_point = k == 0 || rng_.chance(0.2);
      const auto points = static_cast<uint64_t>(points_.size());
      const int32_t a = new_point ? static_cast<int32_t>(rng_.below(points)) : pairs_.back().a;
      pairs_.push_back(
          {a, rng_.chance(0.7) ? partner_[static_cast<size_t>(a)] : static_cast<int32_t>(rng_.below(points))});
    }
  }

  void check_candidates() {
    require_same_of_all_sets();
    rules_.interact = is_odd;
    require_same_of_all_sets();
    // Where nothing is sure.
    rules_.band_constant = std::numeric_limits<float>::infinity();
    require_same_of_all_sets();
  }

  // What came before the stop stays, in whole pieces.
  void check_stopping() {
    const Sent all = expected();
    for (const hg::KernelSet *set : kernel_sets()) {
      RecorderRules rules = rules_;
      rules.rooms = rng_.below(3);
      Recorder recorder(rules);
      const bool done = run(*set, recorder);
      const Sent sent = recorder.finish();
      require(!done || sent == all, "%s: not stopped, but only %zu of %zu pairs", set->name, sent.pairs.size(),
              all.pairs.size());
      require(done || sent.candidates % hg::kMaxPiece == 0, "%s: stopped within a piece", set->name);
      const Sent some = expected(static_cast<size_t>(sent.candidates));
      require(sent == some, "%s: %zu pairs of %lld candidates instead of %zu", set->name, sent.pairs.size(),
              static_cast<long long>(sent.candidates), some.pairs.size());
    }
  }

 private:
  // Around an end of the space or anywhere; most have a partner at about the distance where they touch.
  void make_points() {
    const double scale = std::pow(2, rng_.uniform(0, 29)), spread = scale * rng_.uniform(1, 20);
    double middle[3];
    for (double &x : middle) x = rng_.chance(0.5) ? 0x1p31 : rng_.uniform(-0x1p30, 0x1p31);
    const size_t count = 2 + rng_.below(200);
    for (size_t i = 0; i < count; i++) {
      hg::Point point{};
      point.radius = static_cast<float>(scale * (rng_.chance(0.1) ? 0 : rng_.uniform()));
      double at[3];
      for (int axis = 0; axis < 3; axis++) at[axis] = middle[axis] + spread * rng_.uniform(-1, 1);
      partner_.push_back(static_cast<int32_t>(rng_.below(i + 1)));
      if (partner_[i] < static_cast<int32_t>(i)) put_near(points_[static_cast<size_t>(partner_[i])], point.radius, at);
      point.x = within(at[0]);
      point.y = within(at[1]);
      point.z = within(at[2]);
      points_.push_back(point);
      slot_.push_back(static_cast<uint32_t>(rng_.below(Recorder::kSlots)));  // images share that of their particle
    }
  }

  // Differences of coordinates fit into 32 bits: images lie a box length outside at most.
  int32_t within(double x) { return static_cast<int32_t>(std::clamp(x, -0x1p30 + 1, 0x1p30)); }

  void put_near(const hg::Point &partner, float radius, double *at) {
    const double reach = static_cast<double>(plain_reach(interaction_, partner.radius, radius));
    const double d = reach * (1 + rng_.uniform(-1, 1) * 1e-6) + rng_.uniform(-10, 10);
    double u[3] = {rng_.uniform(-1, 1), rng_.uniform(-1, 1), rng_.chance(0.5) ? 0 : rng_.uniform(-1, 1)};
    const double norm = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    at[0] = partner.x + d * u[0] / norm;
    at[1] = partner.y + d * u[1] / norm;
    at[2] = partner.z + d * u[2] / norm;
  }

  hg_pair slots_of(uint32_t a, uint32_t b) const {
    const auto slot_a = static_cast<int32_t>(slot_[a]), slot_b = static_cast<int32_t>(slot_[b]);
    return {std::min(slot_a, slot_b), std::max(slot_a, slot_b)};
  }

  // Of the first candidates.
  Sent expected(size_t count = SIZE_MAX) const {
    Sent sent;
    for (const hg_pair &pair : pairs_) {
      if (static_cast<size_t>(sent.candidates) == count) break;
      sent.candidates++;
      const auto a = static_cast<uint32_t>(pair.a), b = static_cast<uint32_t>(pair.b);
      const Verdict verdict = plain_test(points_[a], points_[b], interaction_, rules_.band_constant);
      if (rules_.band_constant == hg::kBandConstant) require_truthful(points_[a], points_[b], interaction_, verdict);
      if (!verdict.possible) continue;
      if (!verdict.sure) {
        sent.asked.push_back(pair);
        sent.images.push_back(hg::kNoImage);
        if (!rules_.interact({nullptr, a, b, hg::kNoImage})) continue;
      }
      const hg_pair slots = slots_of(a, b);
      sent.pairs.push_back({slots.a + rules_.id_offset, slots.b + rules_.id_offset});
    }
    return sent;
  }

  bool run(const hg::KernelSet &set, Recorder &recorder) const {
    return set.filter[interaction_]({points_.data(), slot_.data(), pairs_.data(), pairs_.size()}, recorder.stream());
  }

  void require_same_of_all_sets() const {
    const Sent all = expected();
    for (const hg::KernelSet *set : kernel_sets()) {
      Recorder recorder(rules_);
      require(run(*set, recorder), "%s: stopped", set->name);
      const Sent sent = recorder.finish();
      require(sent.candidates == all.candidates, "%s: %lld candidates", set->name,
              static_cast<long long>(sent.candidates));
      require_pairs(set->name, sent.pairs, all.pairs);
      require(sent == all, "%s: asked about %zu pairs instead of %zu, or others", set->name, sent.asked.size(),
              all.asked.size());
    }
  }

  Rng rng_;
  int32_t interaction_;
  RecorderRules rules_;
  std::vector<hg::Point> points_;
  std::vector<uint32_t> slot_;
  std::vector<int32_t> partner_;  // of each point
  Pairs pairs_;
};

// All numbers of candidates around one vector, and any up to a few pieces.
void candidates(void **) {
  assert_true(sweep(40, [](uint64_t seed) { Scene(seed, seed).check_candidates(); }));
  assert_true(sweep(200, [](uint64_t seed) { Scene(seed, Rng(seed).below(kFewPieces)).check_candidates(); }));
}
void stopping(void **) {
  assert_true(sweep(100, [](uint64_t seed) { Scene(seed, kFewPieces).check_stopping(); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(candidates), cmocka_unit_test(stopping)};
  return cmocka_run_group_tests_name("filter_kernel", tests, nullptr, nullptr);
}
