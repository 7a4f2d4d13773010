// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid pack`: makes a packing of a size law and writes it to a particle file.
#include "packing/event/grown_packing.hpp"
#include "packing/packing.hpp"
#include "packing/sizes/report.hpp"
#include "particles/error.hpp"
#include "particles/files/writer.hpp"
#include "particles/text/formatted.hpp"
#include "particles/text/lists.hpp"
#include "particles/text/number.hpp"
#include "particles/text/status_line.hpp"
#include "programs/hgrid/command.hpp"
#include "programs/hgrid/growth_line.hpp"
#include "programs/hgrid/interrupt.hpp"
#include "programs/measure/timing.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace command {
namespace {

struct PackOptions {
  packing::Request request;
  std::string method = "relax";
  std::optional<double> density;
  std::optional<int> sweeps;
  std::optional<double> growth_rate;
  std::string law = "uniform-volume";
  std::string arrangement = "even";
  std::vector<std::optional<double>> law_values;  // in the order of packing::law_parameters()
  std::string sizes;
  std::optional<double> radius;
  std::optional<double> offset;
  bool random_offset = false;
  std::string periodic;
  std::string output;
  std::string format;
};

packing::SizeLaw law_of(const PackOptions &options) {
  packing::SizeLaw law = packing::usual_law(options.law);
  law.dimension = options.request.law.dimension;
  for (size_t k = 0; k < options.law_values.size(); k++) {
    if (!options.law_values[k]) continue;
    const packing::LawParameter &parameter = *packing::law_parameters()[k];
    const std::string fault = packing::set_parameter(law, parameter, *options.law_values[k]);
    if (!fault.empty()) throw CLI::ValidationError(std::string("--") + parameter.name, fault);
  }
  if (options.sizes.empty()) return law;
  const std::string fault = packing::set_sizes(law, options.sizes);
  if (!fault.empty()) throw CLI::ValidationError("--sizes", fault);
  return law;
}

// Of the options only the even arrangement takes all.
void check_arrangement(const PackOptions &options, const packing::Arrangement &arrangement) {
  const auto refuse = [&](const char *option, const char *takers) {
    throw CLI::ValidationError(option, std::string("is for ") + takers + ", not for " + arrangement.name);
  };
  if (options.density && !arrangement.takes_density) refuse("--density", "arrangements that fill something");
  if (arrangement.is_even()) return;
  if (options.method != "relax") throw CLI::ValidationError("--arrangement", "is for --method relax");
  if (options.sweeps) refuse("--sweeps", "the arrangement even");
  if (!options.periodic.empty()) refuse("--periodic", "the arrangement even");
}

packing::Request request_of(const PackOptions &options) {
  packing::Request request = options.request;
  request.law = law_of(options);
  request.arrangement = &packing::arrangement_called(options.arrangement);
  check_arrangement(options, *request.arrangement);
  if (options.sweeps && options.method != "relax") throw CLI::ValidationError("--sweeps", "is for --method relax");
  if (options.growth_rate && options.method != "event") {
    throw CLI::ValidationError("--growth-rate", "is for --method event");
  }
  request.sweeps = options.sweeps.value_or(request.sweeps);
  request.density = options.density.value_or(request.arrangement->density);
  request.offset = options.offset.value_or(request.offset);
  request.random_offset = options.random_offset;
  for (const char axis : options.periodic) {
    const auto place = static_cast<size_t>(axis - 'x');
    if (axis < 'x' || axis > 'z' || place >= static_cast<size_t>(request.law.dimension) || request.periodic[place]) {
      throw CLI::ValidationError("--periodic",
                                 "'" + options.periodic + "' does not name axes of this packing, each once");
    }
    request.periodic[place] = true;
  }
  return request;
}

const particles::Format &format_of(const PackOptions &options) {
  const particles::Format *format =
      options.format.empty() ? particles::format_of_name(options.output) : particles::format_of_word(options.format);
  if (format == nullptr) {
    throw CLI::ValidationError("--output", "'" + options.output + "' has no ending that tells a format: add --format");
  }
  if (format->write == nullptr)
    throw CLI::ValidationError("--output", std::string(format->title) + " is only read, never written");
  return *format;
}

// The file appears under its name only when it is complete.
void write_whole(const std::string &path, const particles::Format &format, const particles::ParticleSet &particles) {
  if (path == "-") return particles::write_particles(path, format, particles);
  const std::string partial = path + ".partial-" + std::to_string(getpid());
  try {
    particles::write_particles(partial, format, particles);
    std::filesystem::rename(partial, path);
  } catch (const std::exception &error) {
    std::error_code ignored;  // the first failure is the one to tell
    std::filesystem::remove(partial, ignored);
    throw particles::Error(error.what());
  }
}

// What is said of a packing goes beside it, not into it.
std::FILE *summary_file(const PackOptions &options) { return options.output == "-" ? stderr : stdout; }

std::string words_of(double density) { return particles::formatted(", density %.6g", density); }

void print_particles(const PackOptions &options, const particles::ParticleSet &set, const std::string &density) {
  const auto [smallest, largest] = std::minmax_element(set.radii.begin(), set.radii.end());
  const std::string box = set.has_box ? particles::formatted("box edge %.9g", set.box_max[0]) : "no box";
  std::fprintf(summary_file(options), "%s: %s, %s, %zu %s, radii %.6g to %.6g, %s%s\n", options.output.c_str(),
               options.law.c_str(), options.arrangement.c_str(), set.count(), set.dimension == 2 ? "disks" : "spheres",
               *smallest, *largest, box.c_str(), density.c_str());
}

double scale_of(const PackOptions &options, const packing::SizeLaw &law) {
  return options.radius ? *options.radius / packing::first_radius(law) : 1;
}

// How well laws that are curves are met.
void print_sizes(const PackOptions &options, const packing::SizeLaw &law, const particles::ParticleSet &set) {
  if (packing::row_of(law.law).curve == nullptr) return;
  const packing::SizeReport report = packing::report_sizes(law, set.radii, scale_of(options, law));
  std::fputs(packing::words_of(report).c_str(), summary_file(options));
}

void relax(const PackOptions &options, const packing::Request &request, const particles::Format &format) {
  const auto start = std::chrono::steady_clock::now();
  packing::Packing packing;
  {
    particles::StatusLine line;
    packing = packing::make_packing(request, [&](int done, const packing::Overlaps &overlaps) {
      line.show(particles::formatted("sweep %d of %d: %zu contacts, mean overlap %.2f %% of the smaller radius", done,
                                     request.sweeps, overlaps.contacts, 100 * overlaps.mean));
    });
  }
  packing::scale(packing.particles, scale_of(options, request.law));
  write_whole(options.output, format, packing.particles);
  print_particles(options, packing.particles, request.arrangement->takes_density ? words_of(request.density) : "");
  std::fprintf(
      summary_file(options), "%zu contacts, overlap over the smaller radius: mean %.2g, largest %.2g; made in %.1f s\n",
      packing.overlaps.contacts, packing.overlaps.mean, packing.overlaps.largest, measure::seconds_since(start));
  print_sizes(options, request.law, packing.particles);
}

void print_growth(const PackOptions &options, const packing::event::GrowthResult &growth, double seconds) {
  const double events = static_cast<double>(growth.tally.events());
  const double per_particle =
      2 * static_cast<double>(growth.tally.collisions) / static_cast<double>(growth.radii.size());
  std::fprintf(summary_file(options),
               "0 overlaps; %.4g events, %.3g per second, %.4g collisions per particle, growth rate %.3g, %d retries, "
               "pressure %.3g NkT/V; made in %.1f s\n",
               events, events / seconds, per_particle, growth.rate, growth.retries, growth.compressibility, seconds);
}

// A growth that was stopped or jammed leaves its file too, but is no success.
void report_early_end(const PackOptions &options, const packing::event::GrowthResult &growth) {
  using packing::event::GrowthEnd;
  if (growth.end == GrowthEnd::kDone) return;
  const std::string what = growth.end == GrowthEnd::kStopped ? "stopped" : "jammed";
  const std::string advice = growth.end == GrowthEnd::kStopped ? "" : "; try a lower --growth-rate";
  throw particles::Error("the growth was " + what + " at density " + particles::text(growth.density) + "; " +
                         options.output + " holds its state, without overlaps" + advice);
}

void grow(const PackOptions &options, const packing::Request &request, const particles::Format &format) {
  const auto start = std::chrono::steady_clock::now();
  packing::event::GrownPacking packing;
  {
    const Interrupt interrupt;
    GrowthLine line;
    packing = packing::event::grow_packing(request, options.growth_rate.value_or(0), [&](const auto &progress) {
      line.show(progress);
      return !interrupt.requested();
    });
  }
  packing::scale(packing.particles, scale_of(options, request.law));
  write_whole(options.output, format, packing.particles);
  print_particles(options, packing.particles, words_of(packing.growth.density));
  print_growth(options, packing.growth, measure::seconds_since(start));
  report_early_end(options, packing.growth);
  print_sizes(options, request.law, packing.particles);
}

void run_pack(const PackOptions &options) {
  const packing::Request request = request_of(options);
  const particles::Format &format = format_of(options);
  if (options.method == "event") {
    grow(options, request, format);
  } else {
    relax(options, request, format);
  }
}

// "What they are:" and a line for each row of a table.
template <class Row>
std::string described(std::string text, const std::vector<Row> &rows, const char *Row::*meaning) {
  for (const Row &row : rows) text += std::string("\n") + row.name + ": " + row.*meaning;
  return text;
}

void add_law_options(CLI::App &command, PackOptions &options) {
  command
      .add_option("--law", options.law,
                  described("Size law of the radii:", packing::size_laws(), &packing::LawRow::radii))
      ->check(CLI::IsMember(particles::names_of(packing::size_laws())))
      ->capture_default_str();
  options.law_values.resize(packing::law_parameters().size());
  for (size_t k = 0; k < options.law_values.size(); k++) {
    const packing::LawParameter &parameter = *packing::law_parameters()[k];
    command.add_option(std::string("--") + parameter.name, options.law_values[k],
                       packing::describe(parameter) + " (" + packing::usual_values(parameter) + ")");
  }
  command.add_option("--sizes", options.sizes, packing::kSizesMeaning);
  command
      .add_option("--radius", options.radius, "Of the smallest size (1; table: as in it; log-normal: of the median)")
      ->check(CLI::PositiveNumber);
}

void add_output_options(CLI::App &command, PackOptions &options) {
  const std::vector<particles::Format> formats = particles::writable_formats();
  std::string endings;
  for (const particles::Format &format : formats) endings += std::string(format.endings) + " ";
  command.add_option("-o,--output", options.output, "File to write: " + endings + "or - for standard output")
      ->required();
  command
      .add_option("--format", options.format,
                  particles::joined(particles::names_of(formats), " or ") + " (by the file's ending)")
      ->check(CLI::IsMember(particles::names_of(formats)));
}

}  // namespace

void add_pack(CLI::App &parent) {
  auto options = std::make_shared<PackOptions>();
  packing::Request &request = options->request;
  CLI::App *command = parent.add_subcommand("pack", "Make a packing of spheres or disks of a size law");
  add_law_options(*command, *options);
  command->add_option("--count", request.count, "Number of particles")->capture_default_str();
  command
      ->add_option("--arrangement", options->arrangement,
                   described("Where particles are:", packing::arrangements(), &packing::Arrangement::places))
      ->check(CLI::IsMember(particles::names_of(packing::arrangements())))
      ->capture_default_str();
  command->add_option("--density", options->density,
                      "Share that the particles fill of the box, or of what their arrangement fills (" +
                          packing::usual_densities() + ")");
  command->add_option("--seed", request.seed, "Same seed, same packing")->capture_default_str();
  CLI::Option *offset =
      command->add_option("--offset", options->offset,
                          "Where in its share of the size law each radius is sampled, from 0 to below 1 (0.5)");
  command->add_flag("--random-offset", options->random_offset, "Draw the offset from the seed")->excludes(offset);
  command
      ->add_option("--method", options->method,
                   "relax: random places, pushed apart, small overlaps stay; event: grown from points, no overlaps")
      ->check(CLI::IsMember({"relax", "event"}))
      ->capture_default_str();
  command->add_option("--sweeps", options->sweeps, "relax: sweeps that push overlapping particles apart (60)");
  command->add_option("--growth-rate", options->growth_rate,
                      "event: growth of the radii at the end, from 0 to 1 per time at thermal speed 1 (0.01 over the "
                      "mean radius)");
  command->add_option("--dimension", request.law.dimension, "2 (disks) or 3 (spheres)")->capture_default_str();
  command->add_option("--periodic", options->periodic, "Axes without walls, e.g. xy (none)");
  add_output_options(*command, *options);
  command->callback([options] { run_pack(*options); });
}

}  // namespace command
