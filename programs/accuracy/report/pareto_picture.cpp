// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Layout and style of the picture. Lengths without a unit named are pixels.
#include "programs/accuracy/report/pareto_picture.hpp"

#include "particles/text/formatted.hpp"
#include "programs/accuracy/report/pareto_front.hpp"
#include "programs/draw/log_axis.hpp"
#include "programs/draw/palette.hpp"
#include "programs/draw/svg.hpp"

#include <algorithm>

namespace accuracy {
namespace {

constexpr double kMargin = 24;
constexpr double kPlotWidth = 330, kPlotHeight = 250;
constexpr double kLeft = 62;    // for the numbers beside the vertical axis
constexpr double kTop = 52;     // for the title
constexpr double kBottom = 44;  // for the numbers and the name of the horizontal axis
constexpr double kStrip = 46;   // where points without error stand
constexpr double kLegendRow = 19;
constexpr double kLetterWidth = 5.2;  // of a label, on average
constexpr size_t kColumns = 3;

constexpr double kSmall = 11;  // letters

// One kind of error of one parameter: a series for each system. Or, of what changes the time alone, its numbers.
struct Panel {
  std::string title, error_of;
  std::vector<Series> series;
  const char *number_of = nullptr;
};

bool has_error(const Point &point) { return point.error > 0; }

std::vector<Panel> panels_of(const std::vector<Study> &studies, const std::vector<Point> &points) {
  std::vector<Panel> panels;
  for (const Study &study : studies) {
    const size_t first = panels.size();
    for (const Series &series : series_of(points)) {
      if (series[0].parameter != study.name) continue;
      const auto begin = panels.begin() + static_cast<ptrdiff_t>(first);
      auto panel = std::find_if(begin, panels.end(), [&](const Panel &p) { return p.error_of == series[0].error_of; });
      if (panel == panels.end()) panel = panels.insert(panel, {study.title, series[0].error_of, {}, study.number_of});
      panel->series.push_back(series);
    }
  }
  // Where nothing is ever wrong there is nothing to draw in a picture of errors.
  const auto numbered = [](const Panel &panel) { return panel.number_of != nullptr; };
  if (std::all_of(panels.begin(), panels.end(), numbered)) return panels;
  const auto is_exact = [](const Panel &panel) {
    return std::none_of(panel.series.begin(), panel.series.end(),
                        [](const Series &s) { return std::any_of(s.begin(), s.end(), has_error); });
  };
  panels.erase(std::remove_if(panels.begin(), panels.end(), is_exact), panels.end());
  return panels;
}

std::string tick_text(double value) {
  return particles::formatted(value < 1e-3 || value > 99999 ? "%.0e" : "%g", value);
}

bool meet(const draw::Frame &a, const draw::Frame &b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

// Of all points of the panel, those above 0.
std::vector<double> values_of(const Panel &panel, double Point::*value) {
  std::vector<double> values;
  for (const Series &series : panel.series) {
    for (const Point &point : series) {
      if (point.*value > 0) values.push_back(point.*value);
    }
  }
  return values;
}

// A panel with its axes, its plot's upper left corner at `corner`.
class Plot {
 public:
  Plot(const Panel &panel, draw::Point corner)
      : panel_(panel),
        frame_{corner.x, corner.y, kPlotWidth, kPlotHeight},
        strip_(panel.number_of == nullptr ? kStrip : 0),
        errors_(values_of(panel, across()), corner.x + strip_, corner.x + kPlotWidth),
        costs_(values_of(panel, &Point::cost), corner.y + kPlotHeight, corner.y) {}

  void draw(draw::Svg &svg) const {
    draw_axes(svg);
    for (size_t k = 0; k < panel_.series.size(); k++)
      draw_series(svg, panel_.series[k], draw::series_color(k), radius_of(k));
    if (panel_.number_of == nullptr) draw_labels(svg);
    draw_legend(svg);
  }

 private:
  double Point::*across() const { return panel_.number_of == nullptr ? &Point::error : &Point::number; }

  draw::Point place(const Point &p) const {
    const double value = p.*across();
    return {value > 0 ? errors_.place(value) : frame_.x + 0.5 * strip_, costs_.place(p.cost)};
  }

  void draw_axes(draw::Svg &svg) const {
    const double bottom = frame_.y + frame_.height, right = frame_.x + frame_.width;
    const std::string grid = "stroke=\"#e2e2e2\" stroke-width=\"1\"";
    svg.text({frame_.x, frame_.y - 26}, panel_.title, 14, "font-weight=\"bold\"");
    svg.text({frame_.x, frame_.y - 9}, "ns per particle", kSmall);
    if (strip_ > 0) svg.rectangle({frame_.x, frame_.y, strip_, frame_.height}, "fill=\"#f3f1ea\"");
    for (const double cost : costs_.ticks()) {
      const double y = costs_.place(cost);
      svg.line({frame_.x, y}, {right, y}, grid);
      svg.text({frame_.x - 6, y + 4}, tick_text(cost), kSmall, "text-anchor=\"end\"");
    }
    for (const double error : errors_.ticks()) {
      const double x = errors_.place(error);
      svg.line({x, frame_.y}, {x, bottom}, grid);
      const bool crowded = strip_ > 0 && x < frame_.x + strip_ + 14;  // by the word under the strip
      if (!crowded) svg.text({x, bottom + 15}, tick_text(error), kSmall, "text-anchor=\"middle\"");
    }
    if (strip_ > 0) svg.text({frame_.x + 0.5 * strip_, bottom + 15}, "none", kSmall, "text-anchor=\"middle\"");
    const std::string name = panel_.number_of == nullptr ? "error: " + panel_.error_of : panel_.number_of;
    svg.text({right, bottom + 32}, name, kSmall, "text-anchor=\"end\"");
    svg.rectangle(frame_, "fill=\"none\" stroke=\"#222\" stroke-width=\"1\"");
  }

  // Series that coincide show as rings around each other.
  double radius_of(size_t series) const {
    const size_t above = panel_.series.size() - 1 - series;
    return std::min(3 + 1.2 * static_cast<double>(above), 6.6);
  }

  // The front is a line; settings off the front are pale. Numbers are joined in order.
  void draw_series(draw::Svg &svg, const Series &series, const std::string &color, double radius) const {
    const Series front = panel_.number_of == nullptr ? pareto_front(series) : series;
    for (size_t k = 0; k + 1 < front.size(); k++) {
      svg.line(place(front[k]), place(front[k + 1]), "stroke=\"" + color + "\" stroke-width=\"1.5\"");
    }
    for (const Point &p : series) {
      const bool best = std::any_of(front.begin(), front.end(), [&](const auto &f) { return f.setting == p.setting; });
      const std::string fill = "fill=\"" + color + "\" fill-opacity=\"" + (best ? "1" : "0.4") + "\"";
      svg.circle(place(p), radius, fill);
      if (p.is_default) svg.circle(place(p), 7.5, "fill=\"none\" stroke=\"" + color + "\" stroke-width=\"1.5\"");
    }
  }

  // Names of settings, of one series only: the others' would hide each other. The front's and the default's come first.
  void draw_labels(draw::Svg &svg) const {
    const Series *longest = &panel_.series.front();
    for (const Series &series : panel_.series) {
      if (pareto_front(series).size() > pareto_front(*longest).size()) longest = &series;
    }
    Series order = pareto_front(*longest);
    for (const bool only_default : {true, false}) {
      for (const Point &p : *longest) {
        if (!only_default || p.is_default) order.push_back(p);
      }
    }
    std::vector<draw::Frame> taken;
    std::vector<std::string> labelled;
    for (const Point &p : order) {
      if (std::find(labelled.begin(), labelled.end(), p.setting) != labelled.end()) continue;
      labelled.push_back(p.setting);
      draw_label(svg, p, taken);
    }
  }

  // Right of the point, else left of it, unless another label is in the way on both sides.
  void draw_label(draw::Svg &svg, const Point &point, std::vector<draw::Frame> &taken) const {
    const draw::Point at = place(point);
    const double width = kLetterWidth * static_cast<double>(point.setting.size());
    for (const bool right : {true, false}) {
      const draw::Frame label{right ? at.x + 10 : at.x - 10 - width, at.y - 14, width, 11};
      const bool inside = label.x > frame_.x && label.x + width < frame_.x + frame_.width && label.y > frame_.y;
      const bool hidden = std::any_of(taken.begin(), taken.end(), [&](const auto &t) { return meet(t, label); });
      if (!inside || hidden) continue;
      taken.push_back(label);
      svg.text({label.x, at.y - 5}, point.setting, 10, "fill-opacity=\"0.8\"");
      return;
    }
  }

  void draw_legend(draw::Svg &svg) const {
    double y = frame_.y + frame_.height + kBottom + 14;
    for (size_t k = 0; k < panel_.series.size(); k++) {
      svg.circle({frame_.x + 6, y - 4}, 4, "fill=\"" + draw::series_color(k) + "\"");
      svg.text({frame_.x + 18, y}, panel_.series[k][0].system, kSmall);
      y += kLegendRow;
    }
  }

  const Panel &panel_;
  draw::Frame frame_;
  double strip_;  // its width
  draw::LogAxis errors_, costs_;
};

}  // namespace

std::string pareto_picture(const std::vector<Study> &studies, const std::vector<Point> &points) {
  const std::vector<Panel> panels = panels_of(studies, points);
  size_t most_series = 0;
  for (const Panel &panel : panels) most_series = std::max(most_series, panel.series.size());
  const double cell_width = kLeft + kPlotWidth + kMargin;
  const double cell_height = kTop + kPlotHeight + kBottom + 24 + kLegendRow * static_cast<double>(most_series);
  size_t columns = std::max<size_t>(1, std::min(kColumns, panels.size()));
  if (columns > 2 && panels.size() % columns == 1) columns--;  // no panel alone in a row
  const size_t rows = (panels.size() + columns - 1) / columns;
  const double width = kMargin + cell_width * static_cast<double>(columns);
  const double height = 2 * kMargin + cell_height * static_cast<double>(rows);
  draw::Svg svg(width, height);
  for (size_t k = 0; k < panels.size(); k++) {
    const size_t row = k / columns, column = k % columns;
    const draw::Point corner{kMargin + kLeft + cell_width * static_cast<double>(column),
                             kMargin + kTop + cell_height * static_cast<double>(row)};
    Plot(panels[k], corner).draw(svg);
  }
  const bool errs = panels.empty() || panels.front().number_of == nullptr;
  svg.text({kMargin, height - kMargin},
           errs ? "Line: settings that no other beats in both. Ring: the default. Shaded: no error at all."
                : "Ring: the default. Results are the same for all.",
           kSmall);
  return svg.document();
}

}  // namespace accuracy
