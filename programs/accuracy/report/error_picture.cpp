// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Layout of the picture. Lengths are pixels.
#include "programs/accuracy/report/error_picture.hpp"

#include "programs/accuracy/report/axes.hpp"
#include "programs/accuracy/report/pareto_front.hpp"
#include "programs/draw/labels.hpp"
#include "programs/draw/palette.hpp"

#include <algorithm>

namespace accuracy {
namespace {

constexpr draw::Frame kFrame{62, 70, 560, 440};
constexpr double kLane = 30;    // of the strip without error: each knob has its own
constexpr double kLegend = 24;  // from the frame to the legend
constexpr double kLegendWidth = 296, kLine = 16, kBetweenKnobs = 14;
constexpr double kBelow = 62;  // the numbers and name of the axis, the note
constexpr double kPoint = 4, kRing = 8;
constexpr double kLabel = 10.5;          // size of the letters
constexpr double kNear = 26, kFar = 90;  // how far a label may be from its point
constexpr size_t kFew = 4;               // points of a knob that are all named, however far
constexpr double kLeaderFrom = 20;       // from there on a line leads to the point

// A knob with its points, their costs in the unit of the picture.
struct Drawn {
  const Knob *knob;
  Series points, front;
  std::string color, ink;  // of points and lines, of words
};

bool same_place(const Point &a, const Point &b) { return a.error == b.error && a.cost == b.cost; }

std::vector<Drawn> drawn_knobs(const Figure &figure, const std::vector<Point> &points) {
  std::vector<Drawn> all;
  for (const Knob &knob : figure.knobs) {
    Drawn drawn{&knob, {}, {}, draw::series_color(all.size()), draw::series_ink(all.size())};
    for (Point point : points) {
      if (!knob.holds(point)) continue;
      point.cost *= knob.times;
      drawn.points.push_back(point);
    }
    if (drawn.points.empty()) continue;
    drawn.front = pareto_front(drawn.points);
    all.push_back(drawn);
  }
  return all;
}

std::vector<double> values_of(const std::vector<Drawn> &all, double Point::*value) {
  std::vector<double> values;
  for (const Drawn &drawn : all) {
    for (const Point &point : drawn.points)
      if (point.*value > 0) values.push_back(point.*value);
  }
  if (values.empty()) values.push_back(1);
  return values;
}

class Plot {
 public:
  Plot(const Figure &figure, const std::vector<Drawn> &all)
      : figure_(figure),
        all_(all),
        strip_(kLane * static_cast<double>(all.size() + 1)),
        errors_(values_of(all, &Point::error), kFrame.x + strip_, kFrame.x + kFrame.width),
        costs_(values_of(all, &Point::cost), kFrame.y + kFrame.height, kFrame.y),
        labels_(kFrame) {}

  void draw(draw::Svg &svg) {
    svg.rectangle({kFrame.x, kFrame.y, strip_, kFrame.height}, "fill=\"#f3f1ea\"");
    const double bottom = kFrame.y + kFrame.height;
    draw_axes(svg, kFrame, errors_, costs_, "relative error", figure_.cost, kFrame.x + strip_);
    svg.text({kFrame.x + strip_ / 2, bottom + 16}, "no error at all", kWords, "text-anchor=\"middle\"");
    for (const bool is_front : {false, true}) {
      for (const Drawn &drawn : all_) draw_knob(svg, drawn, is_front);
    }
    for (const bool must : {true, false}) {
      for (const Drawn &drawn : all_) draw_labels(svg, drawn, must);
    }
    draw_legend(svg);
    svg.text({kFrame.x, bottom + kBelow - 12},
             "Ring: the default. Line: settings that no other of the knob beats in both; the others are pale.", kWords);
  }

 private:
  draw::Point place(const Drawn &drawn, const Point &p) const {
    const double lane = kLane * (static_cast<double>(&drawn - all_.data()) + 1);
    return {p.error > 0 ? errors_.place(p.error) : kFrame.x + lane, costs_.place(p.cost)};
  }

  void draw_knob(draw::Svg &svg, const Drawn &drawn, bool is_front) {
    const auto in_front = [&](const Point &p) {
      return std::any_of(drawn.front.begin(), drawn.front.end(), [&](const Point &f) { return same_place(f, p); });
    };
    if (is_front) {
      for (size_t k = 0; k + 1 < drawn.front.size(); k++) {
        const draw::Point from = place(drawn, drawn.front[k]), to = place(drawn, drawn.front[k + 1]);
        svg.line(from, to, "stroke=\"" + drawn.color + "\" stroke-width=\"1.5\"");
        labels_.avoid_line(from, to);
      }
    }
    for (const Point &p : drawn.points) {
      if (in_front(p) != is_front) continue;
      const draw::Point at = place(drawn, p);
      svg.circle(at, kPoint, "fill=\"" + drawn.color + "\" fill-opacity=\"" + (is_front ? "1" : "0.4") + "\"");
      if (p.is_default) svg.circle(at, kRing, "fill=\"none\" stroke=\"" + drawn.color + "\" stroke-width=\"2\"");
      labels_.avoid_point(at, p.is_default ? kRing : kPoint);
    }
  }

  // The default and both ends of a front must have their names, the others where there is room beside them.
  void draw_labels(draw::Svg &svg, const Drawn &drawn, bool must) {
    for (const Point &p : drawn.points) {
      const bool is_end = same_place(p, drawn.front.front()) || same_place(p, drawn.front.back());
      if ((p.is_default || is_end || drawn.points.size() <= kFew) != must) continue;
      const std::string words = drawn.knob->label(p);
      const draw::Point at = place(drawn, p);
      const auto corner = labels_.place(at, words, kLabel, must ? kFar : kNear);
      if (!corner) continue;
      const double width = draw::Labels::width_of(words, kLabel);
      const draw::Point nearest{std::min(std::max(at.x, corner->x), corner->x + width),
                                std::min(std::max(at.y, corner->y - kLabel), corner->y)};
      if (std::abs(nearest.x - at.x) + std::abs(nearest.y - at.y) > kLeaderFrom)
        svg.line(at, nearest, "stroke=\"" + drawn.color + "\" stroke-width=\"0.6\"");
      svg.text(*corner, words, kLabel,
               "style=\"fill:" + drawn.ink + "\"" + (p.is_default ? " font-weight=\"bold\"" : ""));
    }
  }

  void draw_legend(draw::Svg &svg) const {
    const double x = kFrame.x + kFrame.width + kLegend;
    double y = kFrame.y + 12;
    for (const Drawn &drawn : all_) {
      svg.line({x, y - 4}, {x + 20, y - 4}, "stroke=\"" + drawn.color + "\" stroke-width=\"1.5\"");
      svg.circle({x + 10, y - 4}, kPoint, "fill=\"" + drawn.color + "\"");
      svg.text({x + 28, y}, drawn.knob->question, 12, "font-weight=\"bold\"");
      for (const std::string &line : drawn.knob->answer) svg.text({x + 28, y += kLine}, line, kWords);
      y += kLine + kBetweenKnobs;
    }
  }

  const Figure &figure_;
  const std::vector<Drawn> &all_;
  double strip_;  // its width
  draw::LogAxis errors_, costs_;
  draw::Labels labels_;
};

}  // namespace

std::string error_picture(const Figure &figure, const std::vector<Point> &points) {
  const std::vector<Drawn> all = drawn_knobs(figure, points);
  draw::Svg svg(kFrame.x + kFrame.width + kLegend + kLegendWidth, kFrame.y + kFrame.height + kBelow);
  svg.text({kFrame.x, 28}, figure.title, 16, "font-weight=\"bold\"");
  if (!all.empty()) Plot(figure, all).draw(svg);
  return svg.document();
}

}  // namespace accuracy
