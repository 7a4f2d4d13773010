// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A file without a name, which both processes hold.
#include "programs/bench/complaints.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace bench {

Complaints::Complaints() : file_(std::tmpfile()) {
  if (file_ == nullptr) throw std::runtime_error(std::string("a temporary file failed: ") + std::strerror(errno));
  fcntl(fileno(file_), F_SETFL, O_APPEND);  // a program may open standard error once more
}

Complaints::~Complaints() { std::fclose(file_); }

void Complaints::take() { dup2(fileno(file_), STDERR_FILENO); }

std::string Complaints::reason() const {
  std::rewind(file_);
  std::string last, last_error;
  char text[512];
  while (std::fgets(text, sizeof text, file_) != nullptr) {
    std::string line(text, std::strcspn(text, "\r\n"));
    if (line.empty()) continue;
    if (line.find("ERROR") != std::string::npos) last_error = line;
    last = std::move(line);
  }
  std::string &line = last_error.empty() ? last : last_error;
  std::replace(line.begin(), line.end(), ',', ';');
  return line.empty() ? "" : ": " + line;
}

}  // namespace bench
