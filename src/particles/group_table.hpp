// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which groups of particles meet. Groups that meet the same ones form one class, as the search treats them alike.
#pragma once

#include <hgrid/types.h>

#include <cstdint>

namespace hg {

// A bit for each group, or for each class.
using GroupSet = uint64_t;
static_assert(HG_MAX_GROUPS == 64);

inline bool contains(GroupSet set, int member) { return (set >> member & 1) != 0; }
inline GroupSet only(int member) { return GroupSet{1} << member; }

struct GroupClasses {
  int count = 1;
  int8_t of_group[HG_MAX_GROUPS] = {};  // of groups that have particles
  GroupSet meets[HG_MAX_GROUPS] = {1};  // of each class, the classes that it meets

  bool meet(int a, int b) const { return contains(meets[a], b); }
};

class GroupTable {
 public:
  // At first all meet, each also its own.
  GroupTable() {
    for (GroupSet &row : meets_) row = ~GroupSet{0};
  }

  bool meet(int a, int b) const { return contains(meets_[a], b); }
  void set(int a, int b, bool meet) {
    set_one(a, b, meet);
    set_one(b, a, meet);
  }

  // Of the groups that have particles, in their order; one that meets nothing if there are none.
  GroupClasses classes(GroupSet present) const {
    GroupClasses classes;
    classes.count = 0;
    int first_of[HG_MAX_GROUPS];
    for (int group = 0; group < HG_MAX_GROUPS; group++) {
      if (!contains(present, group)) continue;
      int same = 0;
      while (same < classes.count && ((meets_[first_of[same]] ^ meets_[group]) & present) != 0) same++;
      if (same == classes.count) first_of[classes.count++] = group;
      classes.of_group[group] = static_cast<int8_t>(same);
    }
    classes.meets[0] = 0;
    for (int a = 0; a < classes.count; a++) {
      classes.meets[a] = 0;
      for (int b = 0; b < classes.count; b++) {
        if (meet(first_of[a], first_of[b])) classes.meets[a] |= only(b);
      }
    }
    if (classes.count == 0) classes.count = 1;
    return classes;
  }

 private:
  void set_one(int a, int b, bool meet) { meets_[a] = meet ? meets_[a] | only(b) : meets_[a] & ~only(b); }

  GroupSet meets_[HG_MAX_GROUPS];
};

}  // namespace hg
