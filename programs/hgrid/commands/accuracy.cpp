// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid accuracy`: what accuracy costs in time, for every knob that trades one for the other.
#include "particles/text/output.hpp"
#include "programs/accuracy/law_report.hpp"
#include "programs/accuracy/pareto_picture.hpp"
#include "programs/accuracy/points_file.hpp"
#include "programs/accuracy/report.hpp"
#include "programs/accuracy/search_knobs.hpp"
#include "programs/accuracy/simulation_knobs.hpp"
#include "programs/accuracy/trade.hpp"
#include "programs/hgrid/command.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace command {
namespace {

struct AccuracyOptions {
  std::vector<std::string> knobs;
  bool simulation = false;
  accuracy::Budget budget;
  bool markdown = false;
  std::string from, csv, svg;
};

std::vector<accuracy::Knob> chosen_knobs(const AccuracyOptions &options) {
  const std::vector<accuracy::Knob> &all = options.simulation ? accuracy::simulation_knobs() : accuracy::search_knobs();
  if (options.knobs.empty()) return all;
  std::vector<accuracy::Knob> chosen;
  for (const std::string &name : options.knobs) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const accuracy::Knob &k) { return name == k.name; });
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

// Points that follow laws are many: a row for each law says more than theirs.
std::string text_of(std::vector<accuracy::Knob> knobs, std::vector<accuracy::TradePoint> points,
                    accuracy::Style style) {
  const std::string laws = law_report(points, style);
  const auto has_law = [](const accuracy::TradePoint &point) { return accuracy::has_law(point); };
  points.erase(std::remove_if(points.begin(), points.end(), has_law), points.end());
  const auto is_told = [&](const accuracy::Knob &knob) {
    return std::none_of(points.begin(), points.end(),
                        [&](const accuracy::TradePoint &point) { return point.knob == knob.name; });
  };
  knobs.erase(std::remove_if(knobs.begin(), knobs.end(), is_told), knobs.end());
  return laws + (knobs.empty() ? "" : report(knobs, points, style));
}

std::vector<accuracy::TradePoint> measured_points(accuracy::Budget budget, const std::vector<accuracy::Knob> &knobs) {
  if (budget.quick) {
    budget.timed_count = std::min<size_t>(budget.timed_count, 5000);
    budget.truth_count = std::min<size_t>(budget.truth_count, 600);
    budget.repeats = std::min(budget.repeats, 3);
  }
  std::vector<accuracy::TradePoint> points;
  for (const accuracy::Knob &knob : knobs) {
    const auto progress = [&](const std::string &what) {
      std::fprintf(stderr, "hgrid accuracy: %s: %s\n", knob.name, what.c_str());
    };
    const std::vector<accuracy::TradePoint> found = knob.measure(budget, progress);
    points.insert(points.end(), found.begin(), found.end());
  }
  return points;
}

// Of the points of a file those that belong to the knobs.
std::vector<accuracy::TradePoint> kept_points(const std::string &path, const std::vector<accuracy::Knob> &knobs) {
  std::vector<accuracy::TradePoint> points;
  for (accuracy::TradePoint &point : accuracy::read_points(path)) {
    const auto is_its = [&](const accuracy::Knob &knob) { return point.knob == knob.name; };
    if (std::any_of(knobs.begin(), knobs.end(), is_its)) points.push_back(std::move(point));
  }
  return points;
}

void run_accuracy(const AccuracyOptions &options) {
  const std::vector<accuracy::Knob> knobs = chosen_knobs(options);
  const std::vector<accuracy::TradePoint> points =
      options.from.empty() ? measured_points(options.budget, knobs) : kept_points(options.from, knobs);
  const accuracy::Style style = options.markdown ? accuracy::Style::kMarkdown : accuracy::Style::kText;
  write_text("-", text_of(knobs, points, style));
  if (!options.csv.empty()) accuracy::write_points(options.csv, points);
  if (!options.svg.empty()) write_text(options.svg, pareto_picture(knobs, points));
}

std::string list_of(const std::vector<accuracy::Knob> &knobs) {
  std::string list;
  for (const accuracy::Knob &knob : knobs) list += "  " + std::string(knob.name) + ": " + knob.title + "\n";
  return list;
}

}  // namespace

void add_accuracy(CLI::App &parent) {
  auto options = std::make_shared<AccuracyOptions>();
  CLI::App *command = parent.add_subcommand("accuracy", "Measure what accuracy costs in time");
  accuracy::Budget &budget = options->budget;
  command->add_option("--knob", options->knobs, "Only these knobs: see --help")->delimiter(',');
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
  command->footer("Knobs of the search:\n" + list_of(accuracy::search_knobs()) + "Knobs of the simulation:\n" +
                  list_of(accuracy::simulation_knobs()));
  command->callback([options] { run_accuracy(*options); });
}

}  // namespace command
