// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/hgrid/own_folder.hpp"

#include "particles/error.hpp"

#include <filesystem>

#if defined(_WIN32)
#include <windows.h>
#elif defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

namespace command {
namespace {

namespace fs = std::filesystem;

// Empty if the system does not tell.
fs::path own_path() {
#if defined(_WIN32)
  wchar_t path[32768];
  const DWORD size = sizeof path / sizeof *path;
  const DWORD length = GetModuleFileNameW(nullptr, path, size);
  return length > 0 && length < size ? fs::path(path) : fs::path();
#elif defined(__APPLE__)
  char path[4096];
  uint32_t size = sizeof path;
  return _NSGetExecutablePath(path, &size) == 0 ? fs::path(path) : fs::path();
#else
  std::error_code error;
  for (const char *link : {"/proc/self/exe", "/proc/curproc/file"}) {
    fs::path path = fs::read_symlink(link, error);
    if (!error) return path;
  }
  return {};
#endif
}

}  // namespace

std::string beside_program(const char *below) {
  const fs::path program = own_path();
  if (program.empty()) throw particles::Error("the system does not tell where the program lies");
  return fs::weakly_canonical(program.parent_path() / below).string();
}

}  // namespace command
