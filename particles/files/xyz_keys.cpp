// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The second line of a frame of extended XYZ: key=value among free text.
#include "particles/files/xyz_keys.hpp"

#include "particles/text/number.hpp"

#include <algorithm>

namespace particles {
namespace {

bool is_quote(char letter) { return letter == '"' || letter == '\''; }

class Parser {
 public:
  Parser(const LineCursor &cursor, std::string_view line) : cursor_(cursor), rest_(line) {}

  // The next entry. False at the end of the line.
  bool next(std::pair<std::string, std::string> &entry) {
    rest_ = trimmed(rest_);
    if (rest_.empty()) return false;
    entry = {key(), "T"};
    const std::string_view after = trimmed(rest_);
    if (after.empty() || after.front() != '=') return true;
    rest_ = trimmed(after.substr(1));
    entry.second = value(entry.first);
    return true;
  }

 private:
  // A quote in free text need not end.
  std::string key() {
    std::string text;
    if (is_quote(rest_.front()) && take_quoted(text)) return text;
    return std::string(take(rest_.find_first_of("= \t")));
  }

  std::string value(const std::string &key) {
    std::string text;
    if (rest_.empty()) return text;
    if (is_quote(rest_.front())) {
      if (!take_quoted(text)) cursor_.fail("the quote after " + in_quotes(key) + " does not end");
      return text;
    }
    if (rest_.front() == '[' || rest_.front() == '{') {
      if (!take_list(text)) cursor_.fail("the bracket after " + in_quotes(key) + " does not end");
      return text;
    }
    text = take(rest_.find_first_of(" \t"));
    if (!text.empty() && text.back() == ',') text.pop_back();
    return text;
  }

  std::string_view take(size_t size) {
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(taken.size());
    return taken;
  }

  bool take_quoted(std::string &text) {
    const char quote = rest_.front();
    for (size_t k = 1; k < rest_.size(); k++) {
      if (rest_[k] == quote) {
        take(k + 1);
        return true;
      }
      if (rest_[k] == '\\' && k + 1 < rest_.size()) k++;
      text += rest_[k];
    }
    text.clear();
    return false;
  }

  // What stands in brackets, also nested ones, with blanks in their place.
  bool take_list(std::string &text) {
    int depth = 0;
    for (size_t k = 0; k < rest_.size(); k++) {
      const bool opens = rest_[k] == '[' || rest_[k] == '{', closes = rest_[k] == ']' || rest_[k] == '}';
      depth += opens ? 1 : closes ? -1 : 0;
      text += opens || closes ? ' ' : rest_[k];
      if (depth > 0) continue;
      take(k + 1);
      return true;
    }
    return false;
  }

  const LineCursor &cursor_;
  std::string_view rest_;
};

}  // namespace

XyzKeys::XyzKeys(const LineCursor &cursor, std::string_view line) {
  Parser parser(cursor, line);
  std::pair<std::string, std::string> entry;
  while (parser.next(entry)) entries_.push_back(entry);
}

const std::string *XyzKeys::find(const LineCursor &cursor, std::string_view key) const {
  for (const bool any_case : {false, true}) {
    const std::string *found = nullptr;
    for (const auto &[name, value] : entries_) {
      if (name != key && !(any_case && lower_case(name) == lower_case(key))) continue;
      if (found != nullptr) cursor.fail("the key " + in_quotes(key) + " is given twice");
      found = &value;
    }
    if (found != nullptr) return found;
  }
  return nullptr;
}

}  // namespace particles
