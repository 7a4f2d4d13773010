// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// Text output that never loses an error: a full disk or a closed pipe is reported, not swallowed.
#ifndef APP_OUTPUT_HPP
#define APP_OUTPUT_HPP

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace app {

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
  Output &operator<<(std::int64_t number);
  Output &operator<<(std::int32_t number) { return *this << static_cast<std::int64_t>(number); }
  Output &operator<<(std::size_t number);

  // Writes what is buffered and closes the file (standard output stays open). Throws Error if anything got lost.
  void close();

 private:
  void flush();
  char *reserve(std::size_t size);
  [[noreturn]] void fail(int error) const;

  std::string path_;
  std::FILE *file_;
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;
};

}  // namespace app

#endif
