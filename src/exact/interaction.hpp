// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// When two particles interact: |xi - xj| < base(ri, rj) + margin, or <= if touching counts. A rule is one type that
// says what `base` is, to the kernels, to the predicate in double and in exact arithmetic, and to the choice of levels.
// A new rule is a type here and its place in InteractionRules.
#pragma once

#include "src/base/ordered_bits.hpp"
#include "src/exact/exact_sign.hpp"

#include <hgrid/types.h>

#include <algorithm>
#include <cstdint>

namespace hg {

// How far a particle of radius r searches: slope * r + offset + margin.
struct SearchReach {
  double slope, offset;
};

// HG_CONTACT.
struct SumOfRadii {
  static constexpr int kWidth = 2;  // base(r, r) = kWidth r
  static double base(double ri, double rj) { return ri + rj; }
  template <class V>
  static typename V::Float base(typename V::Float ri, typename V::Float rj) {
    return V::add(ri, rj);
  }
  static void add_base(ExactSum &reach, double ri, double rj) {
    reach.add(ri, 1);
    reach.add(rj, 1);
  }
  // Towards the particles of a level, whose largest radius is given: its own level or a finer one.
  static SearchReach towards(double largest, bool /*own_level*/) { return {1, largest}; }
};

// HG_MAX_RANGE.
struct LargerRadius {
  static constexpr int kWidth = 1;
  static double base(double ri, double rj) { return std::max(ri, rj); }
  template <class V>
  static typename V::Float base(typename V::Float ri, typename V::Float rj) {
    return V::max(ri, rj);
  }
  static void add_base(ExactSum &reach, double ri, double rj) { reach.add(larger_of(ri, rj), 1); }
  static SearchReach towards(double largest, bool own_level) {
    return own_level ? SearchReach{0, largest} : SearchReach{1, 0};
  }
};

template <class... Rules>
struct RuleList {
  static constexpr int32_t kCount = sizeof...(Rules);
};
// By hg_grid_def.interaction.
using InteractionRules = RuleList<SumOfRadii, LargerRadius>;

// Calls body(Rule) with the rule of that number.
template <class Body, class First, class... Rest>
auto with_rule(int32_t kind, Body &&body, RuleList<First, Rest...>) {
  if constexpr (sizeof...(Rest) > 0) {
    if (kind > 0) return with_rule(kind - 1, body, RuleList<Rest...>{});
  }
  return body(First{});
}

struct Interaction {
  int32_t kind = HG_CONTACT;
  double margin = 0;
  bool touching = false;  // <= in place of <

  template <class Body>
  auto with_rule(Body &&body) const {
    return hg::with_rule(kind, body, InteractionRules{});
  }

  // The distance below which two particles interact, in double arithmetic.
  double reach(double ri, double rj) const {
    return with_rule([&](auto rule) { return rule.base(ri, rj); }) + margin;
  }
  void add_reach(ExactSum &sum, double ri, double rj) const {
    with_rule([&](auto rule) { rule.add_base(sum, ri, rj); });
    sum.add(margin, 1);
  }

  // The farthest that two particles of radius <= r can interact: the least edge of a cell on the level that holds them
  // (the paper's s_h >= 2 r, with margin and ranges taken in).
  double diameter(double r) const { return reach(r, r); }

  // For candidates that may come to interact: every reach longer by the skin.
  Interaction widened(double skin) const { return {kind, margin + skin, touching}; }

  // A radius with its share of the margin, so that the kernels know no margin: reach = base(folded ri, folded rj).
  double folded_radius(double r) const {
    return with_rule([&](auto rule) { return r + margin / rule.kWidth; });
  }
};

}  // namespace hg
