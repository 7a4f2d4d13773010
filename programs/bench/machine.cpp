// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The machine as the operating system describes it, the compiler as it describes itself.
#include "programs/bench/machine.hpp"

#include <bench_commit.hpp>
#include <sys/utsname.h>

#include <fstream>
#include <thread>

namespace bench {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  utsname name{};
  return uname(&name) == 0 ? name.machine : "unknown";
}

int processor_count() { return static_cast<int>(std::thread::hardware_concurrency()); }

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__ ", " HGRID_BENCH_BUILD_TYPE;
#else
  return "gcc " __VERSION__ ", " HGRID_BENCH_BUILD_TYPE;
#endif
}

const char *commit() { return HGRID_BENCH_COMMIT; }

}  // namespace bench
