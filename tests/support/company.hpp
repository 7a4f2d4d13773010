// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Who may be whose partner: the groups and bodies of particles, and the table of groups, as plain as can be.
#pragma once

#include "tests/support/compare.hpp"

#include <cstdint>
#include <vector>

namespace hgtest {

struct Member {
  int32_t group = 0, body = -1;
};

class Company {
 public:
  explicit Company(size_t count = 0) : members(count) {}

  bool is_absent(size_t row) const { return members[row].group < 0; }
  size_t present() const {
    size_t count = 0;
    for (size_t row = 0; row < members.size(); row++) count += is_absent(row) ? 0 : 1;
    return count;
  }
  bool may_pair(size_t i, size_t j) const {
    const Member &a = members[i], &b = members[j];
    if (a.group < 0 || b.group < 0 || apart_[a.group][b.group]) return false;
    return a.body < 0 || a.body != b.body;
  }

  // Only those whose row is kept are left.
  void keep(const std::vector<bool> &kept) {
    std::vector<Member> left;
    for (size_t i = 0; i < members.size(); i++) {
      if (kept[i]) left.push_back(members[i]);
    }
    members = left;
  }
  // The grid holds exactly so many, as after hg_set: other ones, of whom nothing is said, or as many as before.
  void set_count(size_t count) {
    if (count != members.size()) members.assign(count, Member{});
  }

  void tell_groups(const Grid &grid) const {
    hgrid::check(hg_set_groups(grid.get(), members.size(), column(&Member::group).data()));
  }
  void tell_bodies(const Grid &grid) const {
    hgrid::check(hg_set_bodies(grid.get(), members.size(), column(&Member::body).data()));
  }
  void set_pair(const Grid &grid, int32_t a, int32_t b, bool meet) {
    apart_[a][b] = apart_[b][a] = !meet;
    hgrid::check(hg_set_group_pair(grid.get(), a, b, meet ? 1 : 0));
  }

  std::vector<Member> members;

 private:
  std::vector<int32_t> column(int32_t Member::*which) const {
    std::vector<int32_t> values;
    for (const Member &member : members) values.push_back(member.*which);
    return values;
  }

  bool apart_[HG_MAX_GROUPS][HG_MAX_GROUPS] = {};
};

}  // namespace hgtest
