// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tables of measured trades, as text and as Markdown.
#include "programs/accuracy/report.hpp"

#include "programs/accuracy/ten_times.hpp"

#include <algorithm>
#include <cstdio>

namespace accuracy {
namespace {

using Row = std::vector<std::string>;

std::string number(double value, const char *format) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string error_text(double error) { return error > 0 ? number(error, "%.2g") : "0"; }
std::string cost_text(double cost) { return number(cost, cost < 10 ? "%.2f" : "%.1f"); }

// Letters, not bytes: words may hold a sign beyond ASCII.
size_t width_of(const std::string &cell) {
  return static_cast<size_t>(
      std::count_if(cell.begin(), cell.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string text_table(const std::vector<Row> &rows) {
  std::vector<size_t> widths(rows[0].size(), 0);
  for (const Row &row : rows) {
    for (size_t k = 0; k < row.size(); k++) widths[k] = std::max(widths[k], width_of(row[k]));
  }
  std::string table;
  for (const Row &row : rows) {
    std::string line;
    for (size_t k = 0; k < row.size(); k++) {
      line += row[k] + std::string(widths[k] - width_of(row[k]) + 2, ' ');
    }
    table += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return table;
}

std::string markdown_table(const std::vector<Row> &rows) {
  std::string table;
  for (const Row &row : rows) {
    for (const std::string &cell : row) table += "| " + cell + " ";
    table += "|\n";
    if (&row != &rows[0]) continue;
    for (size_t k = 0; k < row.size(); k++) table += "|---";
    table += "|\n";
  }
  return table;
}

void add_once(std::vector<std::string> &list, const std::string &text) {
  if (!text.empty() && std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
}

// A setting of a system, whatever kinds of error were measured in the same run.
bool same_run(const TradePoint &a, const TradePoint &b) {
  return a.system == b.system && a.setting == b.setting && a.cost == b.cost;
}

Row row_of(const std::vector<TradePoint> &run, const std::vector<std::string> &kinds) {
  Row row = {run[0].system, run[0].setting + (run[0].is_default ? " (default)" : "")};
  for (const std::string &kind : kinds) {
    const auto found = std::find_if(run.begin(), run.end(), [&](const TradePoint &p) { return p.error_of == kind; });
    row.push_back(found == run.end() ? "" : error_text(found->error));
  }
  row.push_back(cost_text(run[0].cost));
  std::vector<std::string> notes;
  for (const TradePoint &p : run) add_once(notes, p.note);
  row.emplace_back();
  for (const std::string &note : notes) row.back() += (row.back().empty() ? "" : "; ") + note;
  return row;
}

// One row for each setting, one column for each kind of error.
std::string knob_table(const Knob &knob, const std::vector<TradePoint> &points, Style style) {
  std::vector<std::string> kinds;
  std::vector<std::vector<TradePoint>> runs;
  for (const TradePoint &p : points) {
    if (p.knob != knob.name) continue;
    add_once(kinds, p.error_of);
    if (runs.empty() || !same_run(runs.back()[0], p)) runs.emplace_back();
    runs.back().push_back(p);
  }
  std::vector<Row> rows = {{"system", "setting"}};
  rows[0].insert(rows[0].end(), kinds.begin(), kinds.end());
  rows[0].insert(rows[0].end(), {"ns", "note"});
  for (const auto &run : runs) rows.push_back(row_of(run, kinds));
  return heading(knob.title, style) + knob.about + "\n\n" + table_of(rows, style) + "\n";
}

std::string step_text(const Step &step) {
  switch (step.kind) {
    case Step::Kind::kFactor:
      return "x " + number(step.factor, "%.3g");
    case Step::Kind::kToZero:
      return "x " + number(step.factor, "%.3g") + " to no error at all";
    case Step::Kind::kFree:
      break;
  }
  return "nothing: the most accurate is no dearer";
}

std::string ten_times_table(const std::vector<TradePoint> &points, Style style) {
  std::vector<Row> rows = {{"knob", "system", "error of", "from", "to", "error", "ns", "ten times less error costs"}};
  for (const Step &step : ten_times_more(points)) {
    const bool moves = step.kind != Step::Kind::kFree;
    const std::string errors = moves ? error_text(step.from.error) + " to " : "";
    const std::string costs = moves ? cost_text(step.from.cost) + " to " : "";
    rows.push_back({step.from.knob, step.from.system, step.from.error_of, moves ? step.from.setting : "",
                    step.to.setting, errors + error_text(step.to.error), costs + cost_text(step.to.cost),
                    step_text(step)});
  }
  return heading("What ten times more accuracy costs", style) + table_of(rows, style);
}

}  // namespace

std::string table_of(const std::vector<Row> &rows, Style style) {
  return style == Style::kMarkdown ? markdown_table(rows) : text_table(rows);
}

std::string heading(const std::string &title, Style style) {
  return style == Style::kMarkdown ? "### " + title + "\n\n"
                                   : title + "\n" + std::string(width_of(title), '-') + "\n\n";
}

std::string report(const std::vector<Knob> &knobs, const std::vector<TradePoint> &points, Style style) {
  std::string text = ten_times_table(points, style) + "\n";
  for (const Knob &knob : knobs) text += knob_table(knob, points, style);
  return text;
}

}  // namespace accuracy
