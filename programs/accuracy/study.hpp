// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A study varies one parameter that trades accuracy for time, on one or more systems, and records a point for each
// setting and kind of error.
#pragma once

#include "programs/accuracy/point.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace accuracy {

// How much to measure.
struct Budget {
  size_t timed_count = 50000;  // particles of a system that is timed
  size_t truth_count = 10000;  // particles of a system that is compared with the truth pair by pair
  int repeats = 15;            // runs of each setting, in turns; the median counts
  bool quick = false;          // few systems and settings: to try it out

  // Cut down where it is quick.
  Budget limited() const;
};

struct Error {
  std::string of;
  double value = 0;
  std::string note;
};

// What was found of one setting.
struct Finding {
  std::string setting;
  double cost = 0;
  std::vector<Error> errors;
  bool is_default = false;
  double number = 0;
};

// Told what is about to be measured.
using Progress = std::function<void(const std::string &what)>;

// Where the findings of a study become points.
class Recorder {
 public:
  Recorder(std::string parameter, const Budget &budget, Progress progress);

  const Budget &budget() const { return budget_; }
  void tell(const std::string &what) const { progress_(what); }
  // The findings to come are of this system; tells what is done with it.
  void begin(const std::string &system, const std::string &work = "");
  void add(const Finding &finding);
  const std::vector<Point> &points() const { return points_; }

 private:
  std::string parameter_, system_;
  Budget budget_;
  Progress progress_;
  std::vector<Point> points_;
};

struct Study {
  const char *name;   // of the parameter: one word, for --knob and the column `knob`
  const char *title;  // for tables and pictures
  const char *about;  // what is varied, what the error and the cost are: full sentences
  void (*measure)(Recorder &record);
  const char *number_of = nullptr;  // what its settings are numbers of, if they change the time alone and no result
};

// The points of all studies, one after the other; `progress` is told the study's name and what it measures.
std::vector<Point> measured_points(const std::vector<Study> &studies, const Budget &budget, const Progress &progress);

}  // namespace accuracy
