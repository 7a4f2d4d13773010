// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/study.hpp"

#include <algorithm>
#include <utility>

namespace accuracy {

Budget Budget::limited() const {
  if (!quick) return *this;
  Budget limited = *this;
  limited.timed_count = std::min<size_t>(timed_count, 5000);
  limited.truth_count = std::min<size_t>(truth_count, 600);
  limited.repeats = std::min(repeats, 3);
  return limited;
}

Recorder::Recorder(std::string parameter, const Budget &budget, Progress progress)
    : parameter_(std::move(parameter)), budget_(budget), progress_(std::move(progress)) {}

void Recorder::begin(const std::string &system, const std::string &work) {
  tell(work.empty() ? system : system + ", " + work);
  system_ = system;
}

void Recorder::add(const Finding &finding) {
  for (const Error &error : finding.errors) {
    points_.push_back({parameter_, system_, finding.setting, error.of, error.value, finding.cost, finding.is_default,
                       error.note, finding.number});
  }
}

std::vector<Point> measured_points(const std::vector<Study> &studies, const Budget &budget, const Progress &progress) {
  std::vector<Point> points;
  for (const Study &study : studies) {
    Recorder record(study.name, budget.limited(),
                    [&](const std::string &what) { progress(std::string(study.name) + ": " + what); });
    study.measure(record);
    points.insert(points.end(), record.points().begin(), record.points().end());
  }
  return points;
}

}  // namespace accuracy
