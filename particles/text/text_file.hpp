// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A text file in memory and a walk over its lines that knows where it is.
#pragma once

#include "particles/text/progress.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace particles {

struct TextFile {
  std::string name;
  std::string text;
};

// Reads all of `path` ("-": standard input), without the mark of UTF-8; line ends that are CR alone become LF. Throws
// Error if it cannot be read, is empty or in UTF-16.
TextFile load_text(const std::string &path);

class LineCursor {
 public:
  struct Position {
    size_t offset = 0, line = 0;
  };

  // `file` must outlive the cursor.
  explicit LineCursor(const TextFile &file);

  // Goes to the next line, without its end (LF or CR LF). False at the end of the file.
  bool next(std::string_view &line);

  // Goes to the next line, which must be there: else fails with "the file ends" and `missing`, what was to come.
  std::string_view expect(const std::string &missing);

  // Passes over up to `count` lines and returns how many there were.
  size_t skip(size_t count);

  Position position() const { return position_; }
  void seek(Position position) { position_ = position; }
  size_t bytes_left() const { return text_.size() - position_.offset; }

  // Throws Error for the line last read.
  [[noreturn]] void fail(const std::string &message) const { fail(position_.line, message); }
  [[noreturn]] void fail(size_t line, const std::string &message) const;

 private:
  const TextFile &file_;
  std::string_view text_;
  Position position_;
  size_t next_report_ = 0;
  Progress progress_;
};

}  // namespace particles
