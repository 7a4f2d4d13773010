// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The names of the rows of a table, and lists of names as they stand in texts.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace particles {

template <class Row>
std::vector<std::string> names_of(const std::vector<Row> &rows) {
  std::vector<std::string> names;
  names.reserve(rows.size());
  for (const Row &row : rows) names.emplace_back(row.name);
  return names;
}

// "a, b, c", or with another word before the last: "a, b or c".
inline std::string joined(const std::vector<std::string> &names, const char *before_last = ", ") {
  std::string result;
  for (size_t k = 0; k < names.size(); k++)
    result += (k == 0 ? "" : k + 1 < names.size() ? ", " : before_last) + names[k];
  return result;
}

}  // namespace particles
