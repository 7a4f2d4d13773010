// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The far end of a stream of pairs: keeps what a kernel sends, and watches how it is sent.
#pragma once

#include "src/exact/fast_test.hpp"
#include "src/pairs/undecided_pairs.hpp"
#include "tests/unit/same_pairs.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace hgtest {

// What a kernel has sent.
struct Sent {
  Pairs pairs;
  Pairs asked;                    // of the pairs that were left undecided, the names that the kernel gave
  std::vector<hg::Image> images;  // of the first of each
  int64_t candidates = 0;
  bool operator==(const Sent &other) const {
    return same_pairs(pairs, other.pairs) && same_pairs(asked, other.asked) && images == other.images &&
           candidates == other.candidates;
  }
};

struct RecorderRules {
  float band_constant = hg::kBandConstant;
  int32_t id_offset = 0;
  size_t rooms = SIZE_MAX;  // how often there is room once more
  // Whether an undecided pair stays.
  std::function<bool(const hg::UndecidedPair &)> interact = [](const hg::UndecidedPair &) { return true; };
  // What must stand where an undecided pair is noted, but for the offset.
  std::function<hg_pair(const hg::UndecidedPair &)> written = [](const hg::UndecidedPair &pair) {
    return hg_pair{static_cast<int32_t>(std::min(pair.a, pair.b)), static_cast<int32_t>(std::max(pair.a, pair.b))};
  };
};

class Recorder {
 public:
  static constexpr size_t kSlots = 4096;  // that pairs may name

  explicit Recorder(RecorderRules rules)
      : rules_(std::move(rules)), room_(kRoom + kGuard, kNothing), stream_(judge(), output()) {}
  Recorder(const Recorder &) = delete;
  Recorder &operator=(const Recorder &) = delete;

  hg::PairStream *stream() { return &stream_; }

  // All that came, once the kernel has returned.
  Sent finish() {
    decide();
    take();
    require(in_place_, "an undecided pair is not where the kernel says it wrote it");
    require(in_room_, "the kernel wrote beyond its room");
    require(stream_.undecided_total == static_cast<int64_t>(sent_.asked.size()), "undecided pairs are miscounted");
    sent_.candidates = stream_.candidate_total;
    return sent_;
  }

 private:
  static constexpr size_t kRoom = hg::kMaxPiece + hg::kPadding, kGuard = 64;
  static constexpr hg_pair kNothing = {-7, -7};

  hg::PairJudge judge() {
    hg::PairJudge judge{};
    judge.decide = [](hg::PairStream *stream) {
      const_cast<Recorder *>(static_cast<const Recorder *>(stream->judge.source))->decide();
    };
    judge.source = this;
    judge.centers = judge.radii = numbers_.data();
    judge.id_offset = rules_.id_offset;
    judge.band_constant = rules_.band_constant;
    return judge;
  }

  hg::PairOutput output() {
    const auto make_room = [](hg::PairOutput *output, size_t count) {
      auto *self = static_cast<Recorder *>(output->owner);
      self->take();
      return count <= kRoom && self->rules_.rooms-- > 0;
    };
    return {room_.data(), room_.data() + kRoom, this, make_room};
  }

  void decide() {
    for (uint32_t n = 0; n < stream_.undecided_count; n++) {
      const hg::UndecidedPair &pair = stream_.undecided[n];
      hg_pair expected = rules_.written(pair);
      expected.a += rules_.id_offset;
      expected.b += rules_.id_offset;
      in_place_ =
          in_place_ && pair.at >= room_.data() && pair.at < stream_.output.next && pair_equal(*pair.at, expected);
      sent_.asked.push_back({static_cast<int32_t>(pair.a), static_cast<int32_t>(pair.b)});
      sent_.images.push_back(pair.image);
    }
    hg::decide_each(stream_, rules_.interact);
  }

  void take() {
    hg_pair *&next = stream_.output.next;
    sent_.pairs.insert(sent_.pairs.end(), room_.data(), next);
    in_room_ =
        in_room_ && next <= stream_.output.limit &&
        std::all_of(room_.begin() + kRoom, room_.end(), [](const hg_pair &p) { return pair_equal(p, kNothing); });
    next = room_.data();
  }

  RecorderRules rules_;
  std::vector<double> numbers_ = std::vector<double>(3 * kSlots);  // fetched ahead, never read
  Pairs room_;
  hg::PairStream stream_;
  Sent sent_;
  bool in_place_ = true, in_room_ = true;
};

}  // namespace hgtest
