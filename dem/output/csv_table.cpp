// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A table of a run that grows by a row at a time.
#include "dem/output/csv_table.hpp"

#include "particles/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>

namespace output {
namespace {

// The table up to a step, with its header; the header alone if there is none.
std::string table_until(const std::string &path, const std::string &header, uint64_t done) {
  std::string kept = header + '\n', line;
  std::ifstream table(path);
  std::getline(table, line);
  while (std::getline(table, line) && std::strtoull(line.c_str(), nullptr, 10) <= done) kept += line + '\n';
  return kept;
}

}  // namespace

CsvTable::CsvTable(std::string path, const std::string &header, uint64_t done) : path_(std::move(path)) {
  const std::string kept = done > 0 ? table_until(path_, header, done) : header + '\n';
  file_.reset(std::fopen(path_.c_str(), "w"));
  if (!file_ || std::fputs(kept.c_str(), file_.get()) < 0)
    throw particles::Error(path_ + ": cannot write: " + std::strerror(errno));
}

void CsvTable::add(uint64_t step, const std::string &row) {
  std::fprintf(file_.get(), "%llu,%s\n", static_cast<unsigned long long>(step), row.c_str());
  if (std::fflush(file_.get()) != 0) throw particles::Error(path_ + ": cannot write: " + std::strerror(errno));
}

std::string row_of(const std::vector<double> &numbers) {
  std::string row;
  for (const double number : numbers) {
    char text[32];
    std::snprintf(text, sizeof text, "%s%.17g", row.empty() ? "" : ",", number);
    row += text;
  }
  return row;
}

}  // namespace output
