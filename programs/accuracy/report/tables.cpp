// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/report/tables.hpp"

#include "particles/text/formatted.hpp"
#include "programs/accuracy/report/pareto_front.hpp"

#include <algorithm>

namespace accuracy {
namespace {

using Row = std::vector<std::string>;

using particles::formatted;

std::string error_text(double error) { return error > 0 ? formatted("%.2g", error) : "0"; }
std::string cost_text(double cost) { return formatted(cost < 10 ? "%.2f" : "%.1f", cost); }

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
    if (&row != &rows.front()) continue;
    for (size_t k = 0; k < row.size(); k++) table += "|---";
    table += "|\n";
  }
  return table;
}

void add_once(std::vector<std::string> &list, const std::string &text) {
  if (!text.empty() && std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
}

// A setting of a system, whatever kinds of error were measured in the same run.
bool same_run(const Point &a, const Point &b) {
  return a.system == b.system && a.setting == b.setting && a.cost == b.cost;
}

Row row_of(const std::vector<Point> &run, const std::vector<std::string> &kinds) {
  Row row = {run[0].system, run[0].setting + (run[0].is_default ? " (default)" : "")};
  for (const std::string &kind : kinds) {
    const auto found = std::find_if(run.begin(), run.end(), [&](const Point &p) { return p.error_of == kind; });
    row.push_back(found == run.end() ? "" : error_text(found->error));
  }
  row.push_back(cost_text(run[0].cost));
  std::vector<std::string> notes;
  for (const Point &p : run) add_once(notes, p.note);
  row.emplace_back();
  for (const std::string &note : notes) row.back() += (row.back().empty() ? "" : "; ") + note;
  return row;
}

std::string factor_text(const DigitCost &cost) {
  switch (cost.kind) {
    case DigitCost::Kind::kFactor:
      return formatted("x %.3g", cost.factor);
    case DigitCost::Kind::kToZero:
      return formatted("x %.3g to no error at all", cost.factor);
    case DigitCost::Kind::kFree:
      break;
  }
  return "nothing: the most accurate is no dearer";
}

}  // namespace

std::string table_of(const std::vector<Row> &rows, Style style) {
  return style == Style::kMarkdown ? markdown_table(rows) : text_table(rows);
}

std::string heading(const std::string &title, Style style) {
  return style == Style::kMarkdown ? "### " + title + "\n\n"
                                   : title + "\n" + std::string(width_of(title), '-') + "\n\n";
}

// One column for each kind of error.
std::string study_table(const Study &study, const std::vector<Point> &points, Style style) {
  std::vector<std::string> kinds;
  std::vector<std::vector<Point>> runs;
  for (const Point &p : points) {
    if (p.parameter != study.name) continue;
    add_once(kinds, p.error_of);
    if (runs.empty() || !same_run(runs.back()[0], p)) runs.emplace_back();
    runs.back().push_back(p);
  }
  std::vector<Row> rows = {{"system", "setting"}};
  rows[0].insert(rows[0].end(), kinds.begin(), kinds.end());
  rows[0].insert(rows[0].end(), {"ns", "note"});
  for (const auto &run : runs) rows.push_back(row_of(run, kinds));
  return heading(study.title, style) + study.about + "\n\n" + table_of(rows, style) + "\n";
}

std::string digit_cost_table(const std::vector<Point> &points, Style style) {
  std::vector<Row> rows = {{"knob", "system", "error of", "from", "to", "error", "ns", "ten times less error costs"}};
  for (const DigitCost &cost : costs_of_a_digit(points)) {
    const Point &from = cost.from, &to = cost.to;
    const bool moves = cost.kind != DigitCost::Kind::kFree;
    rows.push_back({from.parameter, from.system, from.error_of, moves ? from.setting : "", to.setting,
                    (moves ? error_text(from.error) + " to " : "") + error_text(to.error),
                    (moves ? cost_text(from.cost) + " to " : "") + cost_text(to.cost), factor_text(cost)});
  }
  return heading("What ten times more accuracy costs", style) + table_of(rows, style);
}

}  // namespace accuracy
