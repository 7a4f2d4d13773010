// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Text output that never loses an error.
#include "particles/text/output.hpp"

#include "particles/error.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

namespace particles {
namespace {

constexpr size_t kBufferSize = 1 << 18;
constexpr size_t kNumberSize = 32;  // no double or 64-bit integer is longer in shortest form

}  // namespace

Output::Output(const std::string &path)
    : path_(path == "-" ? "<stdout>" : path),
      file_(path == "-" ? stdout : std::fopen(path.c_str(), "wb")),
      buffer_(new char[kBufferSize]) {
  if (file_ == nullptr) fail(errno);
  // Our buffer is the only one: a failed write shows at once.
  std::setvbuf(file_, nullptr, _IONBF, 0);
}

Output::~Output() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
}

void Output::fail(int error) const { throw Error(path_, 0, std::string("cannot write: ") + std::strerror(error)); }

void Output::flush() {
  const size_t written = std::fwrite(buffer_.get(), 1, used_, file_);
  if (written != used_) fail(errno);
  used_ = 0;
}

void Output::close() {
  flush();
  if (std::fflush(file_) != 0) fail(errno);
  if (file_ == stdout) return;
  std::FILE *closing = file_;
  file_ = nullptr;
  if (std::fclose(closing) != 0) fail(errno);
}

char *Output::reserve(size_t size) {
  if (used_ + size > kBufferSize) flush();
  return buffer_.get() + used_;
}

Output &Output::operator<<(std::string_view text) {
  while (!text.empty()) {
    if (used_ == kBufferSize) flush();
    const size_t part = std::min(text.size(), kBufferSize - used_);
    std::memcpy(buffer_.get() + used_, text.data(), part);
    used_ += part;
    text.remove_prefix(part);
  }
  return *this;
}

Output &Output::operator<<(char letter) {
  *reserve(1) = letter;
  used_++;
  return *this;
}

Output &Output::operator<<(double number) {
  char *first = reserve(kNumberSize);
  used_ += static_cast<size_t>(std::to_chars(first, first + kNumberSize, number).ptr - first);
  return *this;
}

Output &Output::operator<<(int64_t number) {
  char *first = reserve(kNumberSize);
  used_ += static_cast<size_t>(std::to_chars(first, first + kNumberSize, number).ptr - first);
  return *this;
}

Output &Output::operator<<(size_t number) {
  char *first = reserve(kNumberSize);
  used_ += static_cast<size_t>(std::to_chars(first, first + kNumberSize, number).ptr - first);
  return *this;
}

}  // namespace particles
