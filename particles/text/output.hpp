// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Text output that never loses an error: a full disk or a closed pipe is reported, not swallowed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace particles {

// Buffered text to a file or, for "-", to standard output. Call close() at the end: only then is all written.
class Output {
 public:
  explicit Output(const std::string &path);
  ~Output();
  Output(const Output &) = delete;
  Output &operator=(const Output &) = delete;

  Output &operator<<(std::string_view text);
  Output &operator<<(char letter);
  Output &operator<<(double number);  // the shortest text that reads back as the same double
  Output &operator<<(int64_t number);
  Output &operator<<(int32_t number) { return *this << static_cast<int64_t>(number); }
  Output &operator<<(size_t number);

  // Writes what is buffered and closes the file (standard output stays open). Throws Error if anything got lost.
  void close();

 private:
  void flush();
  char *reserve(size_t size);
  [[noreturn]] void fail(int error) const;

  std::string path_;
  std::FILE *file_;
  std::unique_ptr<char[]> buffer_;
  size_t used_ = 0;
};

}  // namespace particles
