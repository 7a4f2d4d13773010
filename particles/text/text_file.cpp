// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A text file in memory and a walk over its lines that knows where it is.
#include "particles/text/text_file.hpp"

#include "particles/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace particles {
namespace {

constexpr size_t kBlock = 1 << 20;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

struct CloseFile {
  void operator()(std::FILE *file) const {
    if (file != stdin) std::fclose(file);
  }
};

// 0 if it has no size, as a pipe.
size_t size_on_disk(const std::string &path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : static_cast<size_t>(size);
}

// Marks and line ends as every reader knows them. Throws Error for text of two bytes a letter.
void make_plain(TextFile &file) {
  std::string &text = file.text;
  if (text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0)
    throw Error(file.name, 0, "the text is in UTF-16; save it in UTF-8");
  if (text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0) text.erase(0, kByteOrderMark.size());
  const bool is_text = text.find('\0') == std::string::npos;
  if (is_text && text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
}

}  // namespace

TextFile load_text(const std::string &path) {
  const bool from_stdin = path == "-";
  TextFile result{from_stdin ? "<stdin>" : path, {}};
  const std::unique_ptr<std::FILE, CloseFile> file(from_stdin ? stdin : std::fopen(path.c_str(), "rb"));
  if (!file) throw Error(result.name, 0, std::string("cannot open: ") + std::strerror(errno));

  const size_t expected = from_stdin ? 0 : size_on_disk(path);
  Progress progress("reading " + result.name, "bytes", expected);
  size_t used = 0;
  for (;;) {
    // One byte more than expected, so that the end shows without another round.
    result.text.resize(std::max(used + kBlock, expected + 1));
    const size_t got = std::fread(&result.text[used], 1, std::min(kBlock, result.text.size() - used), file.get());
    used += got;
    progress.update(used);
    if (got == 0) break;
  }
  if (std::ferror(file.get())) throw Error(result.name, 0, std::string("cannot read: ") + std::strerror(errno));
  result.text.resize(used);
  if (used == 0) throw Error(result.name, 0, "the file is empty");
  make_plain(result);
  return result;
}

LineCursor::LineCursor(const TextFile &file)
    : file_(file), text_(file.text), progress_("parsing " + file.name, "bytes", file.text.size()) {}

bool LineCursor::next(std::string_view &line) {
  if (position_.offset >= text_.size()) return false;
  const size_t first = position_.offset;
  const size_t found = text_.find('\n', first);
  const size_t last = found == std::string_view::npos ? text_.size() : found;
  line = text_.substr(first, last - first);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  position_.offset = found == std::string_view::npos ? last : last + 1;
  position_.line++;
  if (position_.offset > next_report_) {
    next_report_ = position_.offset + kBlock;
    progress_.update(position_.offset);
  }
  return true;
}

std::string_view LineCursor::expect(const std::string &missing) {
  std::string_view line;
  if (!next(line)) fail("the file ends here, " + missing + " is missing");
  return line;
}

size_t LineCursor::skip(size_t count) {
  std::string_view line;
  size_t done = 0;
  while (done < count && next(line)) done++;
  return done;
}

void LineCursor::fail(size_t line, const std::string &message) const { throw Error(file_.name, line, message); }

}  // namespace particles
