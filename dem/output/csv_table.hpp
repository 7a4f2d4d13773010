// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A table of a run that grows by a row at a time, with the step in its first column.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace output {

class CsvTable {
 public:
  // A new file; or, with `done` above 0, an earlier one up to that step, since later rows come again. Throws
  // particles::Error if it cannot be written.
  CsvTable(std::string path, const std::string &header, uint64_t done);

  // Written at once, so that a run can be watched. Throws particles::Error if it gets lost.
  void add(uint64_t step, const std::string &row);

 private:
  struct CloseFile {
    void operator()(std::FILE *file) const { std::fclose(file); }
  };

  std::string path_;
  std::unique_ptr<std::FILE, CloseFile> file_;
};

// Numbers with commas, each so that it reads back as the same.
std::string row_of(const std::vector<double> &numbers);

}  // namespace output
