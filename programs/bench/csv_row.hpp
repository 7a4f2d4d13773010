// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows of the CSV files that measurements are written to.
#pragma once

#include "particles/text/output.hpp"

#include <string>

namespace bench {

// Ends its line when it goes out of scope.
class CsvRow {
 public:
  explicit CsvRow(particles::Output &out) : out_(&out) {}
  ~CsvRow() { *out_ << '\n'; }
  CsvRow(const CsvRow &) = delete;
  CsvRow &operator=(const CsvRow &) = delete;

  CsvRow &text(const std::string &words) {
    comma();
    *out_ << '"';
    for (const char letter : words) *out_ << (letter == '"' ? '\'' : letter);
    *out_ << '"';
    return *this;
  }
  template <class Number>
  CsvRow &number(Number value) {
    comma();
    *out_ << value;
    return *this;
  }
  // Unknown, as a negative number, leaves the field empty.
  CsvRow &known(double value) {
    comma();
    if (value >= 0) *out_ << value;
    return *this;
  }

 private:
  void comma() {
    if (!first_) *out_ << ',';
    first_ = false;
  }

  particles::Output *out_;
  bool first_ = true;
};

}  // namespace bench
