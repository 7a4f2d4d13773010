// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The table of a run against time, as SVG: energies, contacts, overlaps and whatever else the run has recorded.
#pragma once

#include <string>
#include <vector>

namespace draw {

struct RunTable {
  std::vector<std::string> names;            // of the columns; "time" among them
  std::vector<std::vector<double>> columns;  // as many numbers in each

  // Reads energy.csv or bulk.csv. Throws particles::Error naming file, line and value; also if there is no column
  // "time" or no row.
  static RunTable read(const std::string &path);

  // The columns of another table of the same run, with a row for each of these: its clock is left out.
  void append(const RunTable &other);
};

// A panel for the energies, one for contacts, and one for all columns whose names begin with the same word.
std::string run_plot(const RunTable &table, const std::string &title);

}  // namespace draw
