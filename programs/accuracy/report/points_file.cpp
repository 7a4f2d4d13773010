// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/report/points_file.hpp"

#include "particles/text/number.hpp"
#include "particles/text/output.hpp"
#include "particles/text/text_file.hpp"

#include <cmath>
#include <limits>

namespace accuracy {
namespace {

constexpr std::string_view kHeader = "knob,system,setting,number,error_of,error,ns,is_default,note";
enum Column { kParameter, kSystem, kSetting, kNumber, kErrorOf, kError, kCost, kIsDefault, kNote, kColumns };

std::string field(const std::string &text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

// Two quotes in a row inside quotes stand for one.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (size_t k = 0; k < line.size(); k++) {
    if (line[k] == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"') {
      fields.back() += line[k++];
    } else if (line[k] == '"') {
      quoted = !quoted;
    } else if (line[k] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[k];
    }
  }
  return fields;
}

double number_of(const particles::LineCursor &cursor, const std::string &text, const char *column, double least) {
  double value = 0;
  const char *fault = particles::number_fault(text, value);
  if (fault == nullptr && value < least) fault = "is too small";
  if (fault != nullptr) cursor.fail(particles::in_quotes(text) + " in column '" + column + "' " + fault);
  return value;
}

Point point_of(const particles::LineCursor &cursor, const std::vector<std::string> &fields) {
  if (fields.size() != kColumns)
    cursor.fail(std::to_string(fields.size()) + " columns instead of " + std::to_string(kColumns));
  Point point;
  point.parameter = fields[kParameter];
  point.system = fields[kSystem];
  point.setting = fields[kSetting];
  point.number = number_of(cursor, fields[kNumber], "number", -HUGE_VAL);
  point.error_of = fields[kErrorOf];
  point.error = number_of(cursor, fields[kError], "error", 0);
  point.cost = number_of(cursor, fields[kCost], "ns", std::numeric_limits<double>::min());
  point.is_default = fields[kIsDefault] == "1";
  if (!point.is_default && fields[kIsDefault] != "0") {
    cursor.fail(particles::in_quotes(fields[kIsDefault]) + " in column 'is_default' is neither 0 nor 1");
  }
  point.note = fields[kNote];
  return point;
}

}  // namespace

void write_points(const std::string &path, const std::vector<Point> &points) {
  particles::Output out(path);
  out << kHeader << '\n';
  for (const Point &p : points) {
    out << field(p.parameter) << ',' << field(p.system) << ',' << field(p.setting) << ',' << p.number << ','
        << field(p.error_of) << ',' << p.error << ',' << p.cost << ',' << (p.is_default ? '1' : '0') << ','
        << field(p.note) << '\n';
  }
  out.close();
}

std::vector<Point> read_points(const std::string &path) {
  const particles::TextFile file = particles::load_text(path);
  particles::LineCursor cursor(file);
  const std::string_view header = cursor.expect("a header");
  if (header != kHeader) cursor.fail("the header is " + particles::in_quotes(header) + ", not " + std::string(kHeader));
  std::vector<Point> points;
  std::string_view line;
  while (cursor.next(line)) points.push_back(point_of(cursor, fields_of(line)));
  return points;
}

}  // namespace accuracy
