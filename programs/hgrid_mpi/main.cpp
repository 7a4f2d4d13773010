// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The program hgrid-mpi: what hgrid does, over ranks of MPI. The first rank speaks for all.
#include "particles/error.hpp"
#include "programs/hgrid_mpi/command.hpp"

#include <hgrid/hgrid.hpp>

#include <CLI/CLI.hpp>
#include <mpi.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>

namespace {

enum ExitCode { kSuccess = 0, kFailure = 1, kUsage = 2 };

std::string version_text() {
  int major = 0, minor = 0, patch = 0;
  hg_version(&major, &minor, &patch);
  return "hgrid-mpi " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

int run(int argc, char **argv, bool speaks) {
  CLI::App parser("Contacts among particles of very different sizes and their simulation, over ranks of MPI.");
  parser.name("hgrid-mpi");
  parser.set_version_flag("--version", version_text());
  parser.require_subcommand(1);
  parser.footer(
      "Examples:\n"
      "  mpirun -n 4 hgrid-mpi pairs packing.csv --output contacts.csv\n"
      "  mpirun -n 4 hgrid-mpi run scenes/cooling-gas.toml\n"
      "  hgrid-mpi plan packing.csv --ranks 8,64,512,4096\n"
      "Exit code: 0 on success, 1 if the work failed, 2 if the command line is wrong.\n"
      "Manual, where it is installed: man hgrid-mpi, man hgrid-mpi-COMMAND; in the sources docs/guide/mpi.md.");
  command::add_rank_pairs(parser);
  command::add_plan(parser);
  command::add_rank_run(parser);
  try {
    parser.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    std::ostringstream answer, complaint;
    const int code = parser.exit(error, answer, complaint);
    if (speaks) std::cout << answer.str() << std::flush;
    if (speaks) std::cerr << complaint.str();
    return code == 0 ? kSuccess : kUsage;
  }
  return kSuccess;
}

}  // namespace

int main(int argc, char **argv) {
  int rank = 0, code = kFailure;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  // Failures are those of all ranks (hgrid/mpi.h); where memory ends on one alone, the others must not wait.
  try {
    code = run(argc, argv, rank == 0);
  } catch (const particles::Error &error) {
    if (rank == 0) std::fprintf(stderr, "hgrid-mpi: %s\n", error.what());
  } catch (const std::bad_alloc &) {
    std::fprintf(stderr, "hgrid-mpi: rank %d: not enough memory\n", rank);
    MPI_Abort(MPI_COMM_WORLD, kFailure);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "hgrid-mpi: rank %d: %s\n", rank, particles::message_of(error).c_str());
    MPI_Abort(MPI_COMM_WORLD, kFailure);
  }
  MPI_Finalize();
  return code;
}
