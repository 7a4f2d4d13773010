// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a search kernel sends, held against brute force: no pair missed, none twice, none undecided that is sure; the
// same from every instruction set that this machine runs.
#pragma once

#include "tests/unit/kernels/kernel_sets.hpp"
#include "tests/unit/kernels/plain_test.hpp"
#include "tests/unit/kernels/recorder.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace hgtest {

struct Points {
  std::array<std::vector<int32_t>, 3> x;
  std::vector<float> radius;
  std::vector<uint32_t> slot;
  std::vector<hg::Image> image;  // none: no point is an image
  std::vector<int32_t> body;     // none: no point is part of one
  uint32_t count = 0;

  void add(const int32_t *at, float r, uint32_t s) {
    for (int axis = 0; axis < 3; axis++) x[axis].push_back(at[axis]);
    radius.push_back(r);
    slot.push_back(s);
    count++;
  }
  hg::Point point(size_t i) const { return {x[0][i], x[1][i], x[2][i], radius[i]}; }
  hg::PointArrays arrays() const {
    return {x[0].data(),
            x[1].data(),
            x[2].data(),
            radius.data(),
            slot.data(),
            image.empty() ? nullptr : image.data(),
            body.empty() ? nullptr : body.data()};
  }
  bool are_of_one_body(size_t i, const Points &others, size_t j) const {
    return !body.empty() && body[i] >= 0 && body[i] == others.body[j];
  }
  void pad() {
    for (auto &column : x) column.resize(count + hg::kPadding);
    slot.resize(count + hg::kPadding);
    radius.resize(count + hg::kPadding);
    if (!body.empty()) body.resize(count + hg::kPadding);
  }
};

// Of points, which search, against particles, which are found. `run` calls a kernel of a set.
class SearchCheck {
 public:
  explicit SearchCheck(int32_t interaction) : interaction_(interaction) {}

  template <class Run>
  Sent search(Run &&run) {
    Sent sent = run_all({}, run);
    found_ = sorted(sent.pairs.data(), sent.pairs.size());
    asked_.clear();
    for (const hg_pair &pair : sent.asked) asked_.push_back(ordered(pair.a, pair.b));
    std::sort(asked_.begin(), asked_.end(), pair_less);
    require(std::adjacent_find(found_.begin(), found_.end(), pair_equal) == found_.end(), "a pair came twice");
    expected_ = 0;
    return sent;
  }

  // Pair (i of points, j of the particles): is what the kernels say about it true?
  void check_pair(const Points &points, size_t i, const Points &particles, size_t j) {
    const hg_pair pair = ordered(static_cast<int32_t>(points.slot[i]), static_cast<int32_t>(particles.slot[j]));
    const bool found = std::binary_search(found_.begin(), found_.end(), pair, pair_less);
    const bool asked = std::binary_search(asked_.begin(), asked_.end(), pair, pair_less);
    const hg::Point a = points.point(i), b = particles.point(j);
    if (points.are_of_one_body(i, particles, j)) {
      require(!found && !asked, "parts of one body are a pair");
      return;
    }
    const Verdict verdict = plain_test(a, b, interaction_, hg::kBandConstant);
    expected_ += found ? 1 : 0;
    require(!found || verdict.possible, "found against the fast test");
    require(!found || asked == !verdict.sure, "asked about a sure pair, or not about another");
    require_truthful(a, b, interaction_, {found, found && !asked});
  }
  void require_nothing_else() {
    require(expected_ == found_.size(), "%zu pairs, of which %zu exist", found_.size(), expected_);
  }

  // With everything undecided, what a judge takes out is gone, and the other pairs stay in their order.
  template <class Run>
  void check_decisions(Run &&run) {
    RecorderRules rules;
    rules.band_constant = std::numeric_limits<float>::infinity();
    const Sent all = run_all(rules, run);
    require(all.asked.size() == all.pairs.size() && static_cast<int64_t>(all.pairs.size()) <= all.candidates,
            "%zu of %lld candidates are undecided", all.asked.size(), static_cast<long long>(all.candidates));
    rules.id_offset = 1;
    rules.interact = [](const hg::UndecidedPair &pair) { return (pair.a * 7 + pair.b) % 3 != 0; };
    Pairs kept;
    for (size_t k = 0; k < all.pairs.size(); k++) {
      const auto a = static_cast<uint32_t>(all.asked[k].a), b = static_cast<uint32_t>(all.asked[k].b);
      if ((a * 7 + b) % 3 != 0) kept.push_back({all.pairs[k].a + 1, all.pairs[k].b + 1});
    }
    require_pairs("decided", run_all(rules, run).pairs, kept);
  }

  // `Sent` of points that may be images: what is asked about names the image that its point is.
  static void require_images(const Sent &sent, const Points &points, int32_t first_slot) {
    for (size_t k = 0; k < sent.asked.size(); k++) {
      const auto point = static_cast<size_t>(sent.asked[k].a - first_slot);
      require(point < points.count && sent.images[k] == points.image[point], "another image is asked about");
    }
  }

  // An output without room ends the search.
  template <class Run>
  static void check_stopping(Run &&run) {
    RecorderRules rules;
    rules.rooms = 0;
    Recorder recorder(rules);
    const bool done = run(hg::kScalarKernels, recorder.stream());
    const Sent sent = recorder.finish();
    require(done || !sent.pairs.empty(), "stopped without cause");
    require(sent.pairs.size() <= hg::kMaxPiece + hg::kPadding, "went on after being stopped");
  }

 private:
  // The same from all sets: the pairs, their order and what is left undecided.
  template <class Run>
  static Sent run_all(const RecorderRules &rules, Run &&run) {
    Sent first;
    for (const hg::KernelSet *set : kernel_sets()) {
      Recorder recorder(rules);
      require(run(*set, recorder.stream()), "%s: stopped", set->name);
      const Sent sent = recorder.finish();
      if (set == &hg::kScalarKernels) first = sent;
      require(sent == first, "%s: %zu pairs instead of the scalar kernel's %zu, or another order", set->name,
              sent.pairs.size(), first.pairs.size());
    }
    return first;
  }

  static hg_pair ordered(int32_t a, int32_t b) { return a < b ? hg_pair{a, b} : hg_pair{b, a}; }

  int32_t interaction_;
  Pairs found_, asked_;
  size_t expected_ = 0;
};

}  // namespace hgtest
