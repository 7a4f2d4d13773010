// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lengths are pixels.
#include "programs/accuracy/report/number_picture.hpp"

#include "programs/accuracy/report/axes.hpp"
#include "programs/accuracy/report/pareto_front.hpp"
#include "programs/draw/palette.hpp"

#include <algorithm>
#include <iterator>

namespace accuracy {
namespace {

constexpr draw::Frame kFrame{62, 66, 420, 280};
constexpr double kLegend = 56;  // from the frame to its first line
constexpr double kRow = 19;

std::vector<double> values_of(const std::vector<Point> &points, double Point::*value) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const Point &point : points) values.push_back(point.*value);
  return values;
}

}  // namespace

std::string number_picture(const Study &study, const std::vector<Point> &points) {
  std::vector<Point> own;
  std::copy_if(points.begin(), points.end(), std::back_inserter(own),
               [&](const Point &point) { return point.parameter == study.name; });
  const std::vector<Series> all = series_of(own);
  const double below = kFrame.y + kFrame.height + kLegend;
  draw::Svg svg(kFrame.x + kFrame.width + 24, below + kRow * static_cast<double>(all.size() + 1));
  svg.text({kFrame.x, 26}, study.title, kTitle, "font-weight=\"bold\"");
  if (own.empty()) return svg.document();
  const draw::LogAxis numbers(values_of(own, &Point::number), kFrame.x, kFrame.x + kFrame.width);
  const draw::LogAxis costs(values_of(own, &Point::cost), kFrame.y + kFrame.height, kFrame.y);
  draw_axes(svg, kFrame, numbers, costs, study.number_of, "ns per particle and search", kFrame.x);
  for (size_t k = 0; k < all.size(); k++) {
    const std::string color = draw::series_color(k);
    const auto place = [&](const Point &p) { return draw::Point{numbers.place(p.number), costs.place(p.cost)}; };
    for (size_t i = 0; i + 1 < all[k].size(); i++)
      svg.line(place(all[k][i]), place(all[k][i + 1]), "stroke=\"" + color + "\" stroke-width=\"1.5\"");
    for (const Point &p : all[k]) {
      svg.circle(place(p), 3, "fill=\"" + color + "\"");
      if (p.is_default) svg.circle(place(p), 7, "fill=\"none\" stroke=\"" + color + "\" stroke-width=\"1.5\"");
    }
    const double y = below + kRow * static_cast<double>(k);
    svg.circle({kFrame.x + 6, y - 4}, 4, "fill=\"" + color + "\"");
    svg.text({kFrame.x + 18, y}, all[k][0].system, kWords);
  }
  svg.text({kFrame.x, below + kRow * static_cast<double>(all.size())}, "Ring: the default. Results are the same.",
           kWords);
  return svg.document();
}

}  // namespace accuracy
