// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Pair lists compared as sets.
#include "programs/bench/verdict.hpp"

#include "programs/bench/child.hpp"
#include "programs/bench/library_searches.hpp"
#include "programs/bench/pair_sets.hpp"

#include <algorithm>

namespace bench {
namespace {

std::vector<hg_pair> pairs_of_library(const particles::ParticleSet &particles, Accuracy accuracy) {
  Child searcher("reference", [&](Channel &channel) {
    LibrarySetting setting;
    setting.accuracy = accuracy;
    const Search search = library_search(setting).prepare(particles);
    PairView pairs;
    search.run(pairs);
    channel.send_array(sorted(pairs.data(), pairs.size()));
  });
  std::vector<hg_pair> pairs = searcher.channel().receive_array<hg_pair>();
  searcher.wait();
  return pairs;
}

std::string count_text(size_t count, const char *what) { return std::to_string(count) + " pairs " + what; }

}  // namespace

Reference::Reference(const particles::ParticleSet &particles)
    : particles_(&particles),
      exact_(pairs_of_library(particles, Accuracy::kExact)),
      as_doubles_(pairs_of_library(particles, Accuracy::kDouble)) {
  const std::vector<hg_pair> odd = differences(exact_, as_doubles_);
  const auto excused = std::count_if(
      odd.begin(), odd.end(), [&](const hg_pair &pair) { return touch_within(particles, pair, kDoubleRounding); });
  rounded_ = static_cast<size_t>(excused);
  if (rounded_ != odd.size()) {
    own_fault_ = count_text(odd.size() - rounded_, "are decided differently in doubles though they do not just touch");
  }
}

std::string Reference::fault(Accuracy accuracy, const std::vector<hg_pair> &pairs) const {
  const std::vector<hg_pair> &expected = accuracy == Accuracy::kDouble ? as_doubles_ : exact_;
  const std::vector<hg_pair> odd = differences(expected, pairs);
  const auto is_wrong = [&](const hg_pair &pair) {
    if (accuracy == Accuracy::kRounded) return !touch_within(*particles_, pair, kDoubleRounding);
    if (accuracy != Accuracy::kFloat) return true;
    const bool missed = std::binary_search(exact_.begin(), exact_.end(), pair, before);
    return missed || !touch_within(*particles_, pair, kFloatDistance);
  };
  const auto wrong = std::count_if(odd.begin(), odd.end(), is_wrong);
  return wrong == 0 ? "" : count_text(static_cast<size_t>(wrong), "differ");
}

}  // namespace bench
