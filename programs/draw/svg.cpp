// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/draw/svg.hpp"

#include <cstdio>

namespace draw {
namespace {

std::string escaped(const std::string &content) {
  std::string result;
  for (const char letter : content) {
    if (letter == '&') {
      result += "&amp;";
    } else if (letter == '<') {
      result += "&lt;";
    } else if (letter == '>') {
      result += "&gt;";
    } else {
      result += letter;
    }
  }
  return result;
}

}  // namespace

Svg::Svg(double width, double height) : width_(width), height_(height) {
  rectangle({0, 0, width, height}, "fill=\"#ffffff\"");
}

Svg &Svg::operator<<(double number) {
  char text[40];
  int length = std::snprintf(text, sizeof text, "%.2f", number);
  while (text[length - 1] == '0') length--;
  if (text[length - 1] == '.') length--;
  body_.append(text, static_cast<size_t>(length));
  return *this;
}

Svg &Svg::operator<<(const std::string &markup) {
  body_ += markup;
  return *this;
}

void Svg::rectangle(const Frame &frame, const std::string &style) {
  *this << "<rect x=\"" << frame.x << "\" y=\"" << frame.y << "\" width=\"" << frame.width << "\" height=\""
        << frame.height << "\" " << style << "/>\n";
}

void Svg::circle(Point center, double radius, const std::string &style) {
  *this << "<circle cx=\"" << center.x << "\" cy=\"" << center.y << "\" r=\"" << radius << "\"";
  if (!style.empty()) *this << " " << style;
  *this << "/>\n";
}

void Svg::line(Point from, Point to, const std::string &style) {
  *this << "<line x1=\"" << from.x << "\" y1=\"" << from.y << "\" x2=\"" << to.x << "\" y2=\"" << to.y << "\"";
  if (!style.empty()) *this << " " << style;
  *this << "/>\n";
}

void Svg::polyline(const std::vector<Point> &points, const std::string &style) {
  *this << "<polyline points=\"";
  for (const Point &point : points) *this << point.x << "," << point.y << " ";
  *this << "\" " << style << "/>\n";
}

void Svg::text(Point baseline, const std::string &content, double size, const std::string &style) {
  *this << "<text x=\"" << baseline.x << "\" y=\"" << baseline.y
        << "\" font-family=\"Helvetica, Arial, sans-serif\" fill=\"#222\" font-size=\"" << size << "\" " << style << ">"
        << escaped(content) << "</text>\n";
}

void Svg::open_group(const std::string &style) { *this << "<g " << style << ">\n"; }

void Svg::close_group() { *this << "</g>\n"; }

void Svg::open_clip(const Frame &frame) {
  const std::string name = "clip" + std::to_string(++clip_count_);
  *this << "<clipPath id=\"" << name << "\">";
  rectangle(frame, "");
  *this << "</clipPath>\n<g clip-path=\"url(#" << name << ")\">\n";
}

void Svg::close_clip() { close_group(); }

std::string Svg::document() const {
  char head[200];
  std::snprintf(head, sizeof head,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n",
                width_, height_, width_, height_);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + std::string(head) + body_ + "</svg>\n";
}

}  // namespace draw
