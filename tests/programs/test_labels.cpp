// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Words beside points: none covers another, a point, a line or the frame's edge, however crowded it is.
#include "packing/random.hpp"
#include "programs/draw/labels.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

constexpr draw::Frame kFrame{10, 20, 400, 300};
constexpr double kSize = 10, kRadius = 4;

struct Box {
  double left, top, right, bottom;
};

Box box_of(const draw::Point &corner, const std::string &words) {
  return {corner.x, corner.y - 0.82 * kSize, corner.x + draw::Labels::width_of(words, kSize), corner.y + 0.18 * kSize};
}

bool are_apart(const Box &a, const Box &b) {
  return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
}

// Many points of the line, each apart from the box.
bool line_is_apart(const Box &box, const draw::Point &from, const draw::Point &to) {
  for (int k = 0; k <= 1000; k++) {
    const double x = from.x + (to.x - from.x) * k / 1000, y = from.y + (to.y - from.y) * k / 1000;
    if (x > box.left && x < box.right && y > box.top && y < box.bottom) return false;
  }
  return true;
}

bool nothing_is_covered() {
  packing::Random random(3);
  for (int scene = 0; scene < 20; scene++) {
    draw::Labels labels(kFrame);
    std::vector<draw::Point> points;
    for (int k = 0; k < 60; k++) {
      points.push_back({kFrame.x + random.uniform() * kFrame.width, kFrame.y + random.uniform() * kFrame.height});
      labels.avoid_point(points.back(), kRadius);
      if (k % 6 == 5) labels.avoid_line(points[points.size() - 2], points.back());
    }
    std::vector<Box> placed;
    for (const draw::Point &point : points) {
      const std::string words = "HG_EXACT n = 50";
      const auto corner = labels.place(point, words, kSize, 40);
      if (!corner) continue;
      const Box box = box_of(*corner, words);
      if (box.left < kFrame.x || box.right > kFrame.x + kFrame.width || box.top < kFrame.y ||
          box.bottom > kFrame.y + kFrame.height)
        return false;
      for (const Box &other : placed) {
        if (!are_apart(box, other)) return false;
      }
      for (size_t k = 0; k < points.size(); k++) {
        const draw::Point &p = points[k];
        if (!are_apart(box, {p.x - kRadius, p.y - kRadius, p.x + kRadius, p.y + kRadius})) return false;
        if (k % 6 == 5 && !line_is_apart(box, points[k - 1], p)) return false;
      }
      placed.push_back(box);
    }
    std::printf("scene %d: %zu of %zu labels\n", scene, placed.size(), points.size());
    if (placed.size() < 10) return false;
  }
  return true;
}

bool a_lone_label_stands_to_the_right() {
  draw::Labels labels(kFrame);
  labels.avoid_point({100, 100}, kRadius);
  const auto corner = labels.place({100, 100}, "word", kSize, 40);
  return corner && corner->x > 100 + kRadius && corner->x < 115 && std::fabs(corner->y - 103) < 2;
}

bool no_room_is_told() {
  draw::Labels labels({0, 0, 30, 30});
  return !labels.place({15, 15}, "more than there is room for", kSize, 40);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(passes<nothing_is_covered>),
                              cmocka_unit_test(passes<a_lone_label_stands_to_the_right>),
                              cmocka_unit_test(passes<no_room_is_told>)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
