// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/report/axes.hpp"

#include "particles/text/formatted.hpp"

namespace accuracy {
namespace {

std::string tick_text(double value) {
  return particles::formatted(value < 1e-3 || value > 99999 ? "%.0e" : "%g", value);
}

}  // namespace

void draw_axes(draw::Svg &svg, const draw::Frame &frame, const draw::LogAxis &across, const draw::LogAxis &upwards,
               const std::string &name_across, const std::string &name_upwards, double from) {
  const double bottom = frame.y + frame.height, right = frame.x + frame.width;
  const std::string grid = "stroke=\"#e2e2e2\" stroke-width=\"1\"";
  for (const double value : upwards.ticks()) {
    const double y = upwards.place(value);
    svg.line({frame.x, y}, {right, y}, grid);
    svg.text({frame.x - 6, y + 4}, tick_text(value), kWords, "text-anchor=\"end\"");
  }
  for (const double value : across.ticks()) {
    const double x = across.place(value);
    if (x < from) continue;
    svg.line({x, frame.y}, {x, bottom}, grid);
    svg.text({x, bottom + 16}, tick_text(value), kWords, "text-anchor=\"middle\"");
  }
  svg.text({frame.x, frame.y - 10}, name_upwards, kWords);
  svg.text({right, bottom + 34}, name_across, kWords, "text-anchor=\"end\"");
  svg.rectangle(frame, "fill=\"none\" stroke=\"#222\" stroke-width=\"1\"");
}

}  // namespace accuracy
