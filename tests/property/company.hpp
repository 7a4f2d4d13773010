// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Who may be whose partner: the groups and bodies of particles, and the table of groups, as plain as can be.
#pragma once

#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <cstdint>
#include <vector>

namespace hgtest {

class Company {
 public:
  explicit Company(size_t count) : members_(count) {}

  bool is_absent(size_t row) const { return members_[row].group < 0; }
  bool may_pair(size_t i, size_t j) const {
    const Member &a = members_[i], &b = members_[j];
    if (a.group < 0 || b.group < 0 || apart_[a.group][b.group]) return false;
    return a.body < 0 || a.body != b.body;
  }

  void resize(size_t count) { members_.resize(count); }
  void keep(const std::vector<bool> &kept) {
    std::vector<Member> left;
    for (size_t i = 0; i < members_.size(); i++) {
      if (kept[i]) left.push_back(members_[i]);
    }
    members_ = left;
  }
  // Of others, who are in no group yet; the table stays.
  Company of(size_t count) const {
    Company others = *this;
    others.members_.assign(count, Member{});
    return others;
  }

  // Tells the grid something else: of some particles, of all, or what it knows already.
  void change(Rng &rng, const Grid &grid) {
    switch (rng.below(4)) {
      case 0:
        set_groups(rng, grid);
        break;
      case 1:
        set_bodies(rng, grid);
        break;
      case 2:
        set_pair(rng, grid);
        break;
      default:
        hgrid::check(hg_set_groups(grid.get(), members_.size(), column(&Member::group).data()));
        hgrid::check(hg_set_bodies(grid.get(), members_.size(), column(&Member::body).data()));
    }
  }

 private:
  struct Member {
    int32_t group = 0, body = -1;
  };

  std::vector<int32_t> column(int32_t Member::*which) const {
    std::vector<int32_t> values;
    for (const Member &member : members_) values.push_back(member.*which);
    return values;
  }

  void set_groups(Rng &rng, const Grid &grid) {
    if (rng.chance(0.1)) {
      for (Member &member : members_) member.group = 0;
      hgrid::check(hg_set_groups(grid.get(), 0, nullptr));
      return;
    }
    const double absent = rng.chance(0.1) ? 1 : rng.chance(0.5) ? 0 : rng.uniform();
    const int32_t last = rng.chance(0.2) ? HG_MAX_GROUPS - 1 : rng.integer(0, 3);
    for (Member &member : members_) member.group = rng.chance(absent) ? -1 : rng.integer(0, last);
    hgrid::check(hg_set_groups(grid.get(), members_.size(), column(&Member::group).data()));
  }

  void set_bodies(Rng &rng, const Grid &grid) {
    if (rng.chance(0.2)) {
      for (Member &member : members_) member.body = -1;
      hgrid::check(hg_set_bodies(grid.get(), 0, nullptr));
      return;
    }
    const int32_t last = rng.chance(0.5) ? 3 : 1 + static_cast<int32_t>(members_.size() / 4);
    for (Member &member : members_) member.body = rng.chance(0.3) ? -1 : rng.integer(0, last) * 100000;
    hgrid::check(hg_set_bodies(grid.get(), members_.size(), column(&Member::body).data()));
  }

  void set_pair(Rng &rng, const Grid &grid) {
    const int32_t last = rng.chance(0.2) ? HG_MAX_GROUPS - 1 : 3;
    const int32_t a = rng.integer(0, last), b = rng.chance(0.3) ? a : rng.integer(0, last);
    apart_[a][b] = apart_[b][a] = rng.chance(0.6);
    hgrid::check(hg_set_group_pair(grid.get(), a, b, apart_[a][b] ? 0 : 1));
  }

  std::vector<Member> members_;
  bool apart_[HG_MAX_GROUPS][HG_MAX_GROUPS] = {};
};

}  // namespace hgtest
