// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tabulated sizes from a file, refused with words where they are no distribution.
#include "packing/sizes/table.hpp"

#include "particles/files/columns.hpp"
#include "particles/files/header.hpp"
#include "particles/files/reader.hpp"
#include "particles/text/lists.hpp"
#include "particles/text/number.hpp"
#include "particles/text/text_file.hpp"

#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace packing {
namespace {

using particles::in_quotes;

// Columns of shares.
constexpr std::initializer_list<const char *> kShares = {"passing", "volume", "number"};

bool names_table(const std::vector<std::string> &names) {
  return particles::has_name(names, kShares) && particles::has_name(names, {"radius", "r", "diameter", "d"});
}

class TableReader {
 public:
  explicit TableReader(particles::LineCursor &cursor) : cursor_(cursor) {
    std::string_view line;
    if (!next_content(line)) cursor_.fail("no line names the columns (such as diameter,passing)");
    const bool has_values = header_.take_line(cursor_, line, columns_);
    find_size_column();
    find_share_column();
    if (has_values) append(line);
  }

  SizeTable read() {
    std::string_view line;
    while (next_content(line)) append(line);
    if (table_.knots.size() < 2) cursor_.fail("a distribution needs two sizes or more");
    const double whole = table_.knots.back().share;
    if (whole != 100 && whole != 1)
      cursor_.fail("the last share in column " + name(share_) + " is " + particles::text(whole) +
                   ", not 100 (percent) or 1");
    if (table_.knots.front().share == whole) cursor_.fail("nothing lies between the sizes: all shares are equal");
    for (Knot &knot : table_.knots) knot.share /= whole;
    return std::move(table_);
  }

 private:
  // What a line holds that is not a comment.
  bool next_content(std::string_view &line) {
    while (cursor_.next(line)) {
      line = particles::trimmed(line);
      if (line.empty()) continue;
      if (line.front() != '#') return true;
      header_.take_comment(line);
    }
    return false;
  }

  void find_size_column() {
    particles::find_size(cursor_, columns_, particles::ReadOptions());
    if (columns_.diameter >= 0)
      cursor_.fail("columns " + name(columns_.size) + " and " + name(columns_.diameter) + " both give the size");
    table_.is_diameter = columns_.is_diameter;
  }

  void find_share_column() {
    for (const char *column : kShares) {
      const int found = particles::find_column(cursor_, columns_, column);
      if (found < 0) continue;
      if (share_ >= 0) cursor_.fail("columns " + name(share_) + " and " + name(found) + " both give the share");
      share_ = found;
      table_.measure = column[0] == 'n' ? Measure::kNumber : Measure::kVolume;
    }
    if (share_ < 0)
      cursor_.fail("no column passing, volume or number among " + in_quotes(particles::joined(columns_.names)));
  }

  void append(std::string_view line) {
    const std::vector<std::string_view> fields = particles::fields_of(line, columns_.separator);
    if (fields.size() != columns_.names.size())
      cursor_.fail(std::to_string(fields.size()) + " values in " + in_quotes(line) + " where there should be " +
                   std::to_string(columns_.names.size()));
    const auto value = [&](int column) {
      return particles::number_in(cursor_, columns_, fields[static_cast<size_t>(column)], column);
    };
    const double size = value(columns_.size), share = value(share_);
    if (!(size > 0)) fail(columns_.size, size, "is not above 0");
    if (share < 0) fail(share_, share, "is negative");
    if (!table_.knots.empty()) {
      const double last_size = table_.size_of(table_.knots.back().radius), last_share = table_.knots.back().share;
      if (!(size > last_size)) fail(columns_.size, size, "is not above " + particles::text(last_size) + " before it");
      if (share < last_share) fail(share_, share, "is below " + particles::text(last_share) + " before it");
    }
    table_.knots.push_back({table_.radius_of(size), share});
  }

  std::string name(int column) const { return in_quotes(columns_.names[static_cast<size_t>(column)]); }

  [[noreturn]] void fail(int column, double value, const std::string &fault) const {
    cursor_.fail(in_quotes(particles::text(value)) + " in column " + name(column) + " " + fault);
  }

  particles::LineCursor &cursor_;
  particles::Header header_ = {"diameter,passing", names_table};
  particles::Columns columns_;
  int share_ = -1;  // column
  SizeTable table_;
};

}  // namespace

SizeTable read_size_table(const std::string &path) {
  const particles::TextFile file = particles::load_text(path);
  particles::LineCursor cursor(file);
  return TableReader(cursor).read();
}

}  // namespace packing
