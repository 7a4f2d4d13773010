// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The colours of levels, and of series of points.
#pragma once

#include "particles/text/formatted.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <string>

namespace draw {

// Components from 0 to 255.
struct Color {
  double red = 0, green = 0, blue = 0;
};

// From light for the coarsest level to dark for the finest: the few large disks stay quiet, the many small ones show.
constexpr Color kShades[] = {{249, 238, 215}, {246, 207, 152}, {237, 156, 98}, {212, 98, 84},
                             {160, 62, 106},  {104, 50, 118},  {62, 52, 120}};

inline std::string color_text(const Color &color) {
  return particles::formatted("#%02x%02x%02x", static_cast<unsigned>(color.red) & 255u,
                              static_cast<unsigned>(color.green) & 255u, static_cast<unsigned>(color.blue) & 255u);
}

inline Color mix(const Color &from, const Color &to, double share) {
  return {from.red + share * (to.red - from.red), from.green + share * (to.green - from.green),
          from.blue + share * (to.blue - from.blue)};
}

inline Color darker(const Color &color) { return mix({0, 0, 0}, color, 0.62); }

// Level 0 is the finest.
inline Color level_color(size_t level, size_t level_count) {
  if (level_count < 2) return kShades[2];
  constexpr size_t kLast = std::size(kShades) - 1;
  const double place = static_cast<double>(level_count - 1 - level) / static_cast<double>(level_count - 1) * kLast;
  const size_t shade = std::min(static_cast<size_t>(place), kLast - 1);
  return mix(kShades[shade], kShades[shade + 1], place - static_cast<double>(shade));
}

// What is pointed out, and the first series.
constexpr const char kAccent[] = "#1c6ea4";
constexpr const char *kSeriesColors[] = {kAccent, "#d46254", "#3e347a", "#2f8f6b", "#c98a1b", "#7a7a7a", "#b0468f"};

inline std::string series_color(size_t series) { return kSeriesColors[series % std::size(kSeriesColors)]; }

// The same for words, dark enough to be read on white.
inline std::string series_ink(size_t series) {
  const unsigned long color = std::strtoul(series_color(series).c_str() + 1, nullptr, 16);
  const auto part = [color](int shift) { return static_cast<double>(color >> shift & 255u); };
  return color_text(darker({part(16), part(8), part(0)}));
}

}  // namespace draw
