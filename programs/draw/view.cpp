// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/draw/view.hpp"

#include "programs/draw/palette.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace draw {
namespace {

// Where cells that begin at `corner` meet, from `low` on and below `high`.
std::vector<double> cell_edges(double corner, double cell_size, double low, double high) {
  std::vector<double> edges;
  const auto edge = [=](int64_t k) { return corner + static_cast<double>(k) * cell_size; };
  for (auto k = static_cast<int64_t>(std::ceil((low - corner) / cell_size)); edge(k) < high; k++) {
    edges.push_back(edge(k));
  }
  return edges;
}

}  // namespace

View View::fit(const Window &window, Point corner, double side) {
  const double scale = side / std::max(window.width, window.height);
  return {window, {corner.x, corner.y, window.width * scale, window.height * scale}};
}

void draw_disks(Svg &svg, const Slice &slice, const View &view) {
  for (size_t level = slice.levels.size(); level-- > 0;) {
    const Color fill = level_color(level, slice.levels.size());
    svg.open_group("fill=\"" + color_text(fill) + "\" stroke=\"" + color_text(darker(fill)) +
                   "\" stroke-width=\"0.6\"");
    for (const Disk &disk : slice.disks) {
      if (disk.level == level && meets(view.window, disk)) {
        svg.circle(view.point(disk.u, disk.v), disk.radius * view.scale(), "");
      }
    }
    svg.close_group();
  }
}

void draw_cells(Svg &svg, const Slice &slice, const View &view, double cell_size, const std::string &style) {
  const Window &w = view.window;
  svg.open_group(style);
  for (const double u : cell_edges(slice.box.u, cell_size, w.u, w.u + w.width)) {
    svg.line(view.point(u, w.v), view.point(u, w.v + w.height), "");
  }
  for (const double v : cell_edges(slice.box.v, cell_size, w.v, w.v + w.height)) {
    svg.line(view.point(w.u, v), view.point(w.u + w.width, v), "");
  }
  svg.close_group();
}

void draw_partner_cells(Svg &svg, const Slice &slice, const View &view, const Disk &disk, double cell_size,
                        const std::string &style) {
  const double a = disk.sphere_radius + 0.5 * cell_size;
  const auto edge = [cell_size](double corner, double x) {
    return corner + std::floor((x - corner) / cell_size) * cell_size;
  };
  const double u_low = edge(slice.box.u, disk.u - a), u_high = edge(slice.box.u, disk.u + a) + cell_size;
  const double v_low = edge(slice.box.v, disk.v - a), v_high = edge(slice.box.v, disk.v + a) + cell_size;
  const Point top_left = view.point(u_low, v_high);
  svg.rectangle({top_left.x, top_left.y, (u_high - u_low) * view.scale(), (v_high - v_low) * view.scale()}, style);
}

}  // namespace draw
