// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The few elements of SVG that the pictures need, written with two decimals so that files stay small.
#pragma once

#include <string>
#include <vector>

namespace draw {

// A rectangle of the picture, in its pixels; y points down.
struct Frame {
  double x = 0, y = 0, width = 0, height = 0;
};

struct Point {
  double x = 0, y = 0;
};

class Svg {
 public:
  // On white.
  Svg(double width, double height);

  // `style` is a list of presentation attributes, e.g. `fill="none" stroke="#000"`.
  void rectangle(const Frame &frame, const std::string &style);
  void circle(Point center, double radius, const std::string &style);
  void line(Point from, Point to, const std::string &style);
  void polyline(const std::vector<Point> &points, const std::string &style);
  // `content` may hold any characters; `size` is that of the letters, in the one font of all pictures.
  void text(Point baseline, const std::string &content, double size, const std::string &style = "");

  // Everything until the matching close has the style.
  void open_group(const std::string &style);
  void close_group();
  // Everything until the matching close is cut at the frame.
  void open_clip(const Frame &frame);
  void close_clip();

  // The finished document.
  std::string document() const;

 private:
  Svg &operator<<(double number);
  Svg &operator<<(const std::string &markup);

  std::string body_;
  double width_, height_;
  int clip_count_ = 0;
};

}  // namespace draw
