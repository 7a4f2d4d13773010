// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The program hgrid: parses the command line, runs one command, and turns failures into messages and exit codes.
#include "particles/error.hpp"
#include "particles/text/output.hpp"
#include "programs/hgrid/command.hpp"

#include <hgrid/hgrid.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <new>
#include <sstream>
#include <string>

namespace {

enum ExitCode { kSuccess = 0, kFailure = 1, kUsage = 2 };

std::string version_text() {
  int major = 0, minor = 0, patch = 0;
  hg_version(&major, &minor, &patch);
  return "hgrid " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch) +
         "\nthreads: " HGRID_THREADS_TEXT "\ninstruction sets: " HGRID_INSTRUCTION_SETS_TEXT;
}

void describe(CLI::App &parser) {
  parser.name("hgrid");
  parser.set_version_flag("--version", version_text());
  parser.require_subcommand(1);
  parser.failure_message([](const CLI::App *failed, const CLI::Error &error) {
    std::string reason = error.what();
    // The parser only misses a command here, whatever stands in its place.
    if (dynamic_cast<const CLI::RequiredError *>(&error) != nullptr && failed->remaining_size() > 0)
      reason = "'" + failed->remaining().front() + "' is no command";
    return "hgrid: " + reason + "\nhgrid: see hgrid --help or hgrid COMMAND --help\n";
  });
  parser.footer(
      "Examples:\n"
      "  hgrid pack --law uniform-volume --ratio 50 --count 10000 --output packing.csv\n"
      "  hgrid pairs packing.csv --output contacts.csv\n"
      "  hgrid pairs packing.csv --count\n"
      "  hgrid levels packing.csv\n"
      "  hgrid run scenes/bouncing-ball.toml\n"
      "Exit code: 0 on success, 1 if the work failed, 2 if the command line is wrong.\n"
      "Manual, where it is installed: man hgrid, man hgrid-COMMAND; in the sources docs/guide/command.md.");
  command::add_pairs(parser);
  command::add_levels(parser);
  command::add_pack(parser);
  command::add_bench(parser);
  command::add_calibrate(parser);
  command::add_slice(parser);
  command::add_run(parser);
  command::add_plot(parser);
  command::add_picture(parser);
  command::add_scenes(parser);
  command::add_accuracy(parser);
}

// Help and version are answers too: they go the way of all output, where a full disk is noticed.
int finish_parse(const CLI::App &parser, const CLI::ParseError &error) {
  std::ostringstream answer, complaint;
  const int code = parser.exit(error, answer, complaint);
  std::fputs(complaint.str().c_str(), stderr);
  particles::Output out("-");
  out << answer.str();
  out.close();
  return code == 0 ? kSuccess : kUsage;
}

int run(int argc, char **argv) {
  CLI::App parser("Finds every contact among particles of very different sizes.");
  describe(parser);
  try {
    parser.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    return finish_parse(parser, error);
  }
  return kSuccess;
}

}  // namespace

int main(int argc, char **argv) {
  try {
    return run(argc, argv);
  } catch (const particles::Error &error) {
    std::fprintf(stderr, "hgrid: %s\n", error.what());
  } catch (const hgrid::Error &error) {
    std::fprintf(stderr, "hgrid: %s\n", particles::message_of(error).c_str());
  } catch (const std::bad_alloc &) {
    std::fputs("hgrid: not enough memory\n", stderr);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "hgrid: unexpected failure: %s\n", error.what());
  }
  return kFailure;
}
