// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The line that names the columns of a table: the first that is no comment, or a comment before it.
#include "particles/files/header.hpp"

#include "particles/text/number.hpp"

#include <algorithm>
#include <utility>

namespace particles {
namespace {

char separator_of(std::string_view header) {
  for (const char letter : {',', ';', '\t'})
    if (header.find(letter) != std::string_view::npos) return letter;
  return kBlanks;
}

std::vector<std::string> names_between(std::string_view line, char separator) {
  std::vector<std::string> names;
  for (const std::string_view field : fields_of(line, separator)) names.emplace_back(without_quotes(field));
  return names;
}

}  // namespace

std::vector<std::string> names_in_line(std::string_view line) { return names_between(line, separator_of(line)); }

bool has_name(const std::vector<std::string> &names, std::initializer_list<const char *> wanted) {
  return std::any_of(names.begin(), names.end(), [&](const std::string &name) {
    return std::find(wanted.begin(), wanted.end(), lower_case(name)) != wanted.end();
  });
}

bool Header::is_row(const std::vector<std::string> &fields) const {
  double value = 0;
  return !names_table_(fields) && std::any_of(fields.begin(), fields.end(), [&](const std::string &field) {
    return number_fault(field, value) == nullptr;
  });
}

bool Header::take_comment(std::string_view line) {
  constexpr std::string_view kYade = "format ";
  line = trimmed(line.substr(std::min(line.find_first_not_of('#'), line.size())));
  const bool is_yade = line.substr(0, kYade.size()) == kYade;
  if (is_yade) line = trimmed(line.substr(kYade.size()));
  std::vector<std::string> names = is_yade ? names_between(line, '_') : names_in_line(line);
  if (!names_table_(names)) return false;
  // Yade's last word stands for any number of attributes.
  is_open_ = names.back() == "attrs";
  comment_ = std::move(names);
  return true;
}

bool Header::take_line(const LineCursor &cursor, std::string_view line, Columns &columns) {
  columns.separator = separator_of(line);
  columns.names = names_between(line, columns.separator);
  if (!is_row(columns.names)) return false;
  if (known_) return true;
  if (is_open_ && comment_.size() < columns.names.size()) comment_.resize(columns.names.size());
  if (comment_.size() != columns.names.size())
    cursor.fail(std::string("the first line must name the columns (such as ") + example_ + "), but it holds " +
                in_quotes(line));
  columns.names = comment_;
  return true;
}

}  // namespace particles
