// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid accuracy`: what accuracy costs in time, for every parameter that trades one for the other.
#include "particles/text/output.hpp"
#include "programs/accuracy/report/error_picture.hpp"
#include "programs/accuracy/report/number_picture.hpp"
#include "programs/accuracy/report/points_file.hpp"
#include "programs/accuracy/report/report.hpp"
#include "programs/accuracy/search/studies.hpp"
#include "programs/accuracy/simulation/studies.hpp"
#include "programs/accuracy/study.hpp"
#include "programs/hgrid/command.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace command {
namespace {

using accuracy::Point;
using Studies = std::vector<accuracy::Study>;

struct AccuracyOptions {
  std::vector<std::string> names;  // of studies; users know the parameters that they vary as knobs
  bool simulation = false;
  accuracy::Budget budget;
  bool markdown = false;
  std::string from, csv, svg;
};

Studies chosen_studies(const AccuracyOptions &options) {
  const Studies &all = options.simulation ? accuracy::simulation_studies() : accuracy::search_studies();
  if (options.names.empty()) return all;
  Studies chosen;
  for (const std::string &name : options.names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const accuracy::Study &s) { return name == s.name; });
    if (found == all.end()) throw CLI::ValidationError("--knob", "'" + name + "' is no knob");
    chosen.push_back(*found);
  }
  return chosen;
}

void write_text(const std::string &path, const std::string &text) {
  particles::Output out(path);
  out << text;
  out.close();
}

void print_progress(const std::string &what) { std::fprintf(stderr, "hgrid accuracy: %s\n", what.c_str()); }

// Of the points of a file those of the studies.
std::vector<Point> recorded_points(const std::string &path, const Studies &studies) {
  std::vector<Point> points = accuracy::read_points(path);
  const auto is_other = [&](const Point &point) {
    return std::none_of(studies.begin(), studies.end(),
                        [&](const auto &study) { return point.parameter == study.name; });
  };
  points.erase(std::remove_if(points.begin(), points.end(), is_other), points.end());
  return points;
}

// What never errs, asked for alone, is drawn over its numbers.
std::string picture(const AccuracyOptions &options, const Studies &studies, const std::vector<Point> &points) {
  if (studies.size() == 1 && studies[0].number_of != nullptr) return accuracy::number_picture(studies[0], points);
  return accuracy::error_picture(options.simulation ? accuracy::simulation_figure() : accuracy::search_figure(),
                                 points);
}

void run_accuracy(const AccuracyOptions &options) {
  const Studies studies = chosen_studies(options);
  const std::vector<Point> points = options.from.empty()
                                        ? accuracy::measured_points(studies, options.budget, print_progress)
                                        : recorded_points(options.from, studies);
  const accuracy::Style style = options.markdown ? accuracy::Style::kMarkdown : accuracy::Style::kText;
  write_text("-", accuracy::report(studies, points, style));
  if (!options.csv.empty()) accuracy::write_points(options.csv, points);
  if (!options.svg.empty()) write_text(options.svg, picture(options, studies, points));
}

std::string list_of(const Studies &studies) {
  std::string list;
  for (const accuracy::Study &study : studies) list += "  " + std::string(study.name) + ": " + study.title + "\n";
  return list;
}

}  // namespace

void add_accuracy(CLI::App &parent) {
  auto options = std::make_shared<AccuracyOptions>();
  CLI::App *command = parent.add_subcommand("accuracy", "Measure what accuracy costs in time");
  accuracy::Budget &budget = options->budget;
  command->add_option("--knob", options->names, "Only these knobs: see --help")->delimiter(',');
  command->add_flag("--quick", budget.quick, "Small systems and few repeats: to try it out");
  command->add_option("--count", budget.timed_count, "Particles of the systems that are timed")
      ->check(CLI::Range(1000, 100000000))
      ->capture_default_str();
  command->add_option("--truth-count", budget.truth_count, "Particles of the systems whose pairs are all checked")
      ->check(CLI::Range(100, 20000))
      ->capture_default_str();
  command->add_option("--repeats", budget.repeats, "Runs of each setting; the median counts")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_flag("--markdown", options->markdown, "Tables in Markdown");
  command->add_option("--from", options->from, "Measure nothing: tell the points that --csv wrote to this file");
  command->add_option("--csv", options->csv, "Also write all points to this file");
  command->add_option("--svg", options->svg, "Also draw error against time to this file");
  command->add_flag("--simulation", options->simulation, "The knobs of the simulation instead of the search's");
  command->footer("Knobs of the search:\n" + list_of(accuracy::search_studies()) + "Knobs of the simulation:\n" +
                  list_of(accuracy::simulation_studies()));
  command->callback([options] { run_accuracy(*options); });
}

}  // namespace command
