// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lengths are pixels.
#include "programs/draw/run_plot.hpp"

#include "particles/error.hpp"
#include "particles/text/formatted.hpp"
#include "particles/text/number.hpp"
#include "particles/text/text_file.hpp"
#include "programs/draw/linear_axis.hpp"
#include "programs/draw/palette.hpp"
#include "programs/draw/svg.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace draw {
namespace {

constexpr double kLeft = 84, kTop = 64, kWidth = 560, kHeight = 150, kBetween = 46;
constexpr double kRight = 170;  // for the names of the lines
constexpr double kBelow = 46;   // for the numbers and the name of the time
constexpr double kSize = 11;    // of letters
constexpr double kRow = 14;     // between the names of two lines

struct Panel {
  std::string title;
  std::vector<size_t> columns;
};

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  for (const char letter : line) {
    if (letter == ',') {
      fields.emplace_back();
    } else {
      fields.back() += letter;
    }
  }
  return fields;
}

bool is_clock(const std::string &name) { return name == "time" || name == "step"; }

// What a column is drawn with: its energies together, its contacts, else its first word.
std::string panel_of(const std::string &name) {
  constexpr const char *kEnergies[] = {"energy", "translation", "rotation", "contact", "gravity"};
  const bool is_energy = std::find(std::begin(kEnergies), std::end(kEnergies), name) != std::end(kEnergies) ||
                         name.compare(0, 4, "work") == 0 || name.compare(0, 10, "dissipated") == 0;
  if (is_energy) return "energy";
  if (name.find("contacts") != std::string::npos) return "contacts";
  return name.substr(0, name.find('_'));
}

// Of columns that are not 0 throughout.
std::vector<Panel> panels_of(const RunTable &table) {
  std::vector<Panel> panels;
  for (size_t k = 0; k < table.names.size(); k++) {
    const std::vector<double> &values = table.columns[k];
    if (is_clock(table.names[k]) || std::all_of(values.begin(), values.end(), [](double value) { return value == 0; }))
      continue;
    const std::string title = panel_of(table.names[k]);
    auto found = std::find_if(panels.begin(), panels.end(), [&](const Panel &panel) { return panel.title == title; });
    if (found == panels.end()) found = panels.insert(panels.end(), {title, {}});
    found->columns.push_back(k);
  }
  for (Panel &panel : panels) {
    if (panel.columns.size() == 1) panel.title = table.names[panel.columns[0]];
    std::replace(panel.title.begin(), panel.title.end(), '_', ' ');
  }
  return panels;
}

std::string tick_text(double value) { return particles::formatted("%.4g", std::fabs(value) < 1e-300 ? 0.0 : value); }

// Heights of names at the ends of lines, moved apart until each has its row; none stands lower than `lowest`, where the
// numbers of the time are.
std::vector<double> spread(const std::vector<double> &heights, double lowest) {
  std::vector<size_t> order(heights.size());
  for (size_t k = 0; k < order.size(); k++) order[k] = k;
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return heights[a] < heights[b]; });
  std::vector<double> moved = heights;
  for (int pass = 0; pass < 200; pass++) {
    for (size_t k = 0; k + 1 < order.size(); k++) {
      const double lacks = kRow - (moved[order[k + 1]] - moved[order[k]]);
      if (lacks <= 0) continue;
      moved[order[k]] -= lacks / 2;
      moved[order[k + 1]] += lacks / 2;
    }
  }
  for (size_t k = order.size(); k-- > 0;) {
    moved[order[k]] = std::min(moved[order[k]], lowest);
    lowest = moved[order[k]] - kRow;
  }
  return moved;
}

void draw_panel(Svg &svg, const RunTable &table, const Panel &panel, const LinearAxis &time, size_t clock, double top) {
  double low = 0, high = 0;  // 0 always shows
  for (const size_t k : panel.columns) {
    const auto [least, most] = std::minmax_element(table.columns[k].begin(), table.columns[k].end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  const double room = 0.04 * (high - low);
  const LinearAxis values(low < 0 ? low - room : low, high + room, top + kHeight, top);
  const Frame frame{kLeft, top, kWidth, kHeight};
  for (const double tick : values.ticks()) {
    const double y = values.place(tick);
    svg.line({kLeft, y}, {kLeft + kWidth, y}, "stroke=\"#e2e2e2\"");
    svg.text({kLeft - 6, y + 4}, tick_text(tick), kSize, "text-anchor=\"end\"");
  }
  for (const double tick : time.ticks()) {
    const double x = time.place(tick);
    svg.line({x, top}, {x, top + kHeight}, "stroke=\"#e2e2e2\"");
    svg.text({x, top + kHeight + 15}, tick_text(tick), kSize, "text-anchor=\"middle\"");
  }
  svg.text({kLeft, top - 8}, panel.title, kSize + 1, "font-weight=\"bold\"");
  svg.rectangle(frame, "fill=\"none\" stroke=\"#222\"");
  std::vector<double> ends;
  for (size_t i = 0; i < panel.columns.size(); i++) {
    const std::vector<double> &column = table.columns[panel.columns[i]];
    std::vector<Point> points;
    for (size_t row = 0; row < column.size(); row++)
      points.push_back({time.place(table.columns[clock][row]), values.place(column[row])});
    svg.polyline(points, "fill=\"none\" stroke=\"" + series_color(i) + "\" stroke-width=\"1.5\"");
    ends.push_back(points.back().y);
  }
  const std::vector<double> heights = spread(ends, top + kHeight - 3);
  for (size_t i = 0; i < panel.columns.size(); i++) {
    std::string name = table.names[panel.columns[i]];
    std::replace(name.begin(), name.end(), '_', ' ');
    svg.text({kLeft + kWidth + 8, heights[i] + 4}, name, kSize, "style=\"fill:" + series_ink(i) + "\"");
  }
}

}  // namespace

RunTable RunTable::read(const std::string &path) {
  const particles::TextFile file = particles::load_text(path);
  particles::LineCursor cursor(file);
  RunTable table;
  table.names = fields_of(cursor.expect("a header"));
  if (std::find(table.names.begin(), table.names.end(), "time") == table.names.end())
    cursor.fail("there is no column 'time'");
  table.columns.resize(table.names.size());
  std::string_view line;
  while (cursor.next(line)) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() != table.names.size()) {
      cursor.fail(std::to_string(fields.size()) + " columns instead of " + std::to_string(table.names.size()));
    }
    for (size_t k = 0; k < fields.size(); k++) {
      double value = 0;
      const char *fault = particles::number_fault(fields[k], value);
      if (fault != nullptr)
        cursor.fail(particles::in_quotes(fields[k]) + " in column '" + table.names[k] + "' " + fault);
      table.columns[k].push_back(value);
    }
  }
  if (table.columns[0].empty()) throw particles::Error(path, 0, "no row");
  return table;
}

void RunTable::append(const RunTable &other) {
  if (other.columns[0].size() != columns[0].size())
    throw particles::Error("the tables of the run differ in their rows");
  for (size_t k = 0; k < other.names.size(); k++) {
    if (is_clock(other.names[k])) continue;
    names.push_back(other.names[k]);
    columns.push_back(other.columns[k]);
  }
}

std::string run_plot(const RunTable &table, const std::string &title) {
  const std::vector<Panel> panels = panels_of(table);
  const auto clock =
      static_cast<size_t>(std::find(table.names.begin(), table.names.end(), "time") - table.names.begin());
  const double height = kTop + static_cast<double>(panels.size()) * (kHeight + kBetween);
  Svg svg(kLeft + kWidth + kRight, height + kBelow - kBetween);
  svg.text({kLeft, 26}, title, 15, "font-weight=\"bold\"");
  const std::vector<double> &times = table.columns[clock];
  const LinearAxis time(times.front(), times.back(), kLeft, kLeft + kWidth);
  double top = kTop;
  for (const Panel &panel : panels) {
    draw_panel(svg, table, panel, time, clock, top);
    top += kHeight + kBetween;
  }
  svg.text({kLeft + kWidth, height + kBelow - kBetween - 12}, "time", kSize, "text-anchor=\"end\"");
  return svg.document();
}

}  // namespace draw
