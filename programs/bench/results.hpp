// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Results as a table for people and as CSV for plots and tables of documents.
#pragma once

#include "programs/bench/rounds.hpp"

#include <string>
#include <vector>

namespace bench {

// What was measured on one system.
struct Measurement {
  std::string sweep;  // "" or the name of the sweep that it belongs to
  std::string system;
  double size_ratio = 1;
  size_t particles = 0;
  std::vector<Result> results;
};

void print(const Measurement &measurement);

// All measurements so far; the file is written anew.
void write_csv(const std::string &path, const std::vector<Measurement> &measurements);

}  // namespace bench
