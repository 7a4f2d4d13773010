// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid plot`: what a run has recorded, against time.
#include "particles/text/output.hpp"
#include "programs/draw/run_plot.hpp"
#include "programs/hgrid/command.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace command {
namespace {

struct PlotOptions {
  std::string run, output, title;
};

void run_plot(const PlotOptions &options) {
  const std::filesystem::path run = options.run;
  const bool is_folder = std::filesystem::is_directory(run);
  const std::filesystem::path table = is_folder ? run / "energy.csv" : run;
  const std::string title = options.title.empty() ? options.run : options.title;
  draw::RunTable all = draw::RunTable::read(table.string());
  if (is_folder && std::filesystem::exists(run / "bulk.csv")) {
    all.append(draw::RunTable::read((run / "bulk.csv").string()));
  }
  particles::Output out(options.output.empty() ? (table.parent_path() / "energy.svg").string() : options.output);
  out << draw::run_plot(all, title);
  out.close();
}

}  // namespace

void add_plot(CLI::App &parent) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App *command = parent.add_subcommand("plot", "Draw energies, contacts and more of a run against time, as SVG");
  command->add_option("RUN", options->run, "Folder of the run, or its energy.csv")->required();
  command->add_option("-o,--output", options->output,
                      "Picture to write, - for standard output; else energy.svg beside");
  command->add_option("--title", options->title, "Of the picture, instead of the run's name");
  command->callback([options] { run_plot(*options); });
}

}  // namespace command
