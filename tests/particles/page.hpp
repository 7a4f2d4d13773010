// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a page of the documentation tells what a table of the program says.
#pragma once

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace test {

inline bool page_has(const std::string &page, const std::string &line) {
  std::ifstream file(page);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (text.find(line) != std::string::npos) return true;
  std::fprintf(stderr, "%s lacks the line: %s", page.c_str(), line.c_str());
  return false;
}

}  // namespace test
