// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/draw/labels.hpp"

#include <algorithm>
#include <cmath>

namespace draw {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kGap = 2;      // pixels between words and what they must not cover
constexpr double kNearest = 9;  // distance of words from their point
constexpr double kRing = 4;     // between two distances that are tried
constexpr int kDirections = 16;
constexpr double kLetterShare = 0.58, kCapitalShare = 0.74;  // widths over the size, on average, of bold letters too

bool meet(const Frame &a, const Frame &b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

// Whether a line from p to q goes through the box: what of it lies between the box's sides on both axes.
bool crosses(const Frame &box, Point p, Point q) {
  double from = 0, to = 1;
  const auto cut = [&](double start, double end, double low, double high) {
    const double change = end - start;
    if (std::fabs(change) < 1e-12) return start >= low && start <= high;
    const double one = (low - start) / change, other = (high - start) / change;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
    return from <= to;
  };
  return cut(p.x, q.x, box.x, box.x + box.width) && cut(p.y, q.y, box.y, box.y + box.height);
}

}  // namespace

double Labels::width_of(const std::string &words, double size) {
  double width = 0;
  for (const char c : words) {
    const bool continues = (static_cast<unsigned char>(c) & 0xc0u) == 0x80;
    if (!continues) width += (c >= 'A' && c <= 'Z' ? kCapitalShare : kLetterShare) * size;
  }
  return width;
}

void Labels::avoid_point(Point center, double radius) {
  taken_.push_back({center.x - radius, center.y - radius, 2 * radius, 2 * radius});
}

void Labels::avoid_line(Point from, Point to) { lines_.insert(lines_.end(), {from, to}); }

bool Labels::is_free(const Frame &box) const {
  const bool inside = box.x >= inside_.x && box.y >= inside_.y && box.x + box.width <= inside_.x + inside_.width &&
                      box.y + box.height <= inside_.y + inside_.height;
  if (!inside || std::any_of(taken_.begin(), taken_.end(), [&](const Frame &other) { return meet(box, other); }))
    return false;
  for (size_t k = 0; k + 1 < lines_.size(); k += 2) {
    if (crosses(box, lines_[k], lines_[k + 1])) return false;
  }
  return true;
}

std::optional<Point> Labels::place(Point point, const std::string &words, double size, double reach) {
  const double width = width_of(words, size);
  const int rings = static_cast<int>((reach - kNearest) / kRing) + 1;
  for (int ring = 0; ring < rings; ring++) {
    const double distance = kNearest + ring * kRing;
    for (int k = 0; k < kDirections; k++) {
      // To the right first, then in turns above and below it, to the left last.
      const int turns = (k + 1) / 2;
      const double angle = (k % 2 == 0 ? -1 : 1) * turns * 2 * kPi / kDirections;
      const double x = point.x + distance * std::cos(angle), y = point.y + distance * std::sin(angle);
      // The side of the words that looks at the point touches the circle; above and below they stand in the middle.
      const double left = x - width * (1 - std::cos(angle)) / 2;
      const double top = y - size * (1 - std::sin(angle)) / 2;
      const Frame box{left - kGap, top - kGap, width + 2 * kGap, size + 2 * kGap};
      if (!is_free(box)) continue;
      taken_.push_back(box);
      return Point{left, top + 0.82 * size};
    }
  }
  return std::nullopt;
}

}  // namespace draw
