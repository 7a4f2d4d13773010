// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Layout and style of the slice picture. Lengths without a unit named are pixels.
#include "programs/draw/slice_picture.hpp"

#include "particles/text/formatted.hpp"
#include "programs/draw/palette.hpp"
#include "programs/draw/svg.hpp"
#include "programs/draw/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace draw {
namespace {

constexpr double kMargin = 20;
constexpr double kOverviewSide = 760;
constexpr double kCloseUpSide = 420;
constexpr double kGap = 40;
constexpr double kLegendRow = 24;
constexpr size_t kMostDisks = 20000;  // about 1.5 MB
// The close-up is this many finest cells wide; up to the second number if that makes a particle of level 2 fit well.
constexpr double kCellsAcrossCloseUp = 11;
constexpr double kMostCellsAcrossCloseUp = 20;
// The overview leaves out cells of which more than that lie side by side: their lines would hide the particles.
constexpr double kMostCellsAcross = 16;
constexpr int kCandidatesPerAxis = 24;

constexpr char kStrongLines[] = "stroke=\"#14304a\" stroke-width=\"1.5\" stroke-opacity=\"0.8\"";
constexpr char kThinLines[] =
    "stroke=\"#14304a\" stroke-width=\"0.8\" stroke-opacity=\"0.45\" stroke-dasharray=\"4 3\"";
constexpr double kLetters = 13;

std::string accent_line(int width) {
  return "stroke=\"" + std::string(kAccent) + "\" stroke-width=\"" + std::to_string(width) + "\"";
}

std::string number_text(double number) { return particles::formatted("%.4g", number); }

// Groups of three digits, a narrow no-break space between them.
std::string count_text(size_t count) {
  std::string digits = std::to_string(count);
  for (size_t place = digits.size(); place > 3; place -= 3) digits.insert(place - 3, "\u202f");
  return digits;
}

Window middle_of(const Window &window, double share) {
  return {window.u + 0.5 * (1 - share) * window.width, window.v + 0.5 * (1 - share) * window.height,
          share * window.width, share * window.height};
}

// The whole box, or the part in its middle that has not too many disks.
Window overview_window(const Slice &slice) {
  Window window = slice.box;
  double share = 1;
  while (count_in(slice, window) > kMostDisks) {
    share *= 0.8;
    window = middle_of(slice.box, share);
  }
  return window;
}

// The particle by which the close-up explains a search: on a coarser level, cut near its equator, and so that all cells
// of the finest level show in which partners can lie.
bool explains_search(const Slice &slice, const Window &window, const Disk &disk) {
  const double reach = disk.sphere_radius + 1.6 * slice.levels.front().cell_size;
  return disk.level > 0 && disk.radius > 0.8 * disk.sphere_radius && disk.u - reach > window.u &&
         disk.u + reach < window.u + window.width && disk.v - reach > window.v &&
         disk.v + reach < window.v + window.height;
}

std::optional<Disk> search_example(const Slice &slice, const Window &window) {
  const auto found = std::find_if(slice.disks.begin(), slice.disks.end(),
                                  [&](const Disk &disk) { return explains_search(slice, window, disk); });
  return found == slice.disks.end() ? std::nullopt : std::optional<Disk>(*found);
}

// How much a close-up of this window tells: above all a search, of a large particle if possible; then many levels and
// particles.
double interest(const Slice &slice, const Window &window) {
  std::vector<bool> seen(slice.levels.size(), false);
  double disks = 0;
  for (const Disk &disk : slice.disks) {
    if (!meets(window, disk)) continue;
    seen[disk.level] = true;
    disks++;
  }
  const double levels = static_cast<double>(std::count(seen.begin(), seen.end(), true));
  const std::optional<Disk> example = search_example(slice, window);
  return disks + 10 * levels + (example ? 1000 + 100 * example->radius / window.width : 0);
}

double close_up_side(const Slice &slice, const Window &overview) {
  const double finest = slice.levels[0].cell_size;
  double side = kCellsAcrossCloseUp * finest;
  if (slice.levels.size() > 1) {
    side = std::max(side, std::min(1.8 * slice.levels[1].cell_size, kMostCellsAcrossCloseUp * finest));
  }
  return std::min({side, overview.width, overview.height});
}

Window close_up_window(const Slice &slice, const Window &overview) {
  const double side = close_up_side(slice, overview);
  Window best;
  double best_interest = -1;
  for (int i = 0; i <= kCandidatesPerAxis; i++) {
    for (int j = 0; j <= kCandidatesPerAxis; j++) {
      const Window window{overview.u + (overview.width - side) * i / kCandidatesPerAxis,
                          overview.v + (overview.height - side) * j / kCandidatesPerAxis, side, side};
      const double found = interest(slice, window);
      if (found > best_interest) {
        best_interest = found;
        best = window;
      }
    }
  }
  return best;
}

// The levels whose cells a panel shows: more than two would hide the particles.
using ShownLevels = std::vector<size_t>;

// The coarsest, and the next whose cells are clearly smaller.
ShownLevels overview_levels(const Slice &slice) {
  const double longer_side = std::max(slice.box.width, slice.box.height);
  ShownLevels shown;
  for (size_t level = slice.levels.size(); level-- > 0 && shown.size() < 2;) {
    const double size = slice.levels[level].cell_size;
    if (longer_side < kMostCellsAcross * size && (shown.empty() || size < 0.6 * slice.levels[shown[0]].cell_size)) {
      shown.push_back(level);
    }
  }
  return shown;
}

// The finest, and the next whose cells are at least twice as wide.
ShownLevels close_up_levels(const Slice &slice) {
  ShownLevels shown{0};
  for (size_t level = 1; level < slice.levels.size() && shown.size() < 2; level++) {
    if (slice.levels[level].cell_size > 2 * slice.levels[0].cell_size) shown.push_back(level);
  }
  return shown;
}

void draw_panel(Svg &svg, const Slice &slice, const View &view, const ShownLevels &shown) {
  svg.open_clip(view.frame);
  draw_disks(svg, slice, view);
  for (const size_t level : shown) {
    const bool strong = level == *std::max_element(shown.begin(), shown.end());
    draw_cells(svg, slice, view, slice.levels[level].cell_size, strong ? kStrongLines : kThinLines);
  }
  svg.close_clip();
}

void draw_search(Svg &svg, const Slice &slice, const View &view, const Disk &disk) {
  svg.open_clip(view.frame);
  draw_partner_cells(svg, slice, view, disk, slice.levels.front().cell_size,
                     "fill=\"" + std::string(kAccent) + "\" fill-opacity=\"0.2\" " + accent_line(2));
  svg.circle(view.point(disk.u, disk.v), disk.radius * view.scale(), "fill=\"none\" " + accent_line(3));
  svg.close_clip();
}

void draw_frames(Svg &svg, const View &overview, const View &close_up) {
  const Window &w = close_up.window;
  const Point top_left = overview.point(w.u, w.v + w.height);
  const double side = w.width * overview.scale();
  const Frame mark{top_left.x, top_left.y, side, side};
  svg.rectangle(overview.frame, "fill=\"none\" stroke=\"#222\" stroke-width=\"1\"");
  svg.rectangle(mark, "fill=\"none\" stroke=\"#ffffff\" stroke-width=\"6\"");
  svg.rectangle(mark, "fill=\"none\" " + accent_line(3));
  svg.rectangle(close_up.frame, "fill=\"none\" " + accent_line(3));
}

void draw_legend(Svg &svg, const Slice &slice, Point corner) {
  const std::array<double, 3> columns = {corner.x + 34, corner.x + 190, corner.x + 330};
  const std::string bold = "font-weight=\"bold\"", right = "text-anchor=\"end\"", bold_right = bold + " " + right;
  svg.text({columns[0], corner.y}, "level", kLetters, bold);
  svg.text({columns[1], corner.y}, "cell size", kLetters, bold_right);
  svg.text({columns[2], corner.y}, "particles", kLetters, bold_right);
  double y = corner.y;
  for (size_t level = 0; level < slice.levels.size(); level++) {
    y += kLegendRow;
    const Color fill = level_color(level, slice.levels.size());
    svg.circle({corner.x + 12, y - 4.5}, 8,
               "fill=\"" + color_text(fill) + "\" stroke=\"" + color_text(darker(fill)) + "\" stroke-width=\"1\"");
    svg.text({columns[0], y}, std::to_string(level + 1), kLetters);
    svg.text({columns[1], y}, number_text(slice.levels[level].cell_size), kLetters, right);
    svg.text({columns[2], y}, count_text(slice.levels[level].particle_count), kLetters, right);
  }
}

// Says what the lines and the shading are.
void draw_notes(Svg &svg, const Slice &slice, const Window &overview, bool has_example, Point corner) {
  const auto levels_text = [](ShownLevels levels) {
    std::sort(levels.begin(), levels.end());
    std::string text = levels.size() > 1 ? "levels " : "level ";
    for (size_t k = 0; k < levels.size(); k++) text += (k > 0 ? " and " : "") + std::to_string(levels[k] + 1);
    return text;
  };
  const ShownLevels in_overview = overview_levels(slice);
  const std::string in_close_up = "in the close-up: cells of " + levels_text(close_up_levels(slice));
  std::vector<std::string> notes;
  notes.emplace_back(in_overview.empty() ? "lines " + in_close_up
                                         : "lines: cells of " + levels_text(in_overview) + "; " + in_close_up);
  if (has_example) notes.emplace_back("shaded: cells of level 1 that the paper's search visits");
  if (overview.width < slice.box.width) {
    notes.push_back("only the middle of the box is drawn, " + number_text(100 * overview.width / slice.box.width) +
                    " % of its width");
  }
  for (const std::string &note : notes) {
    svg.text(corner, note, kLetters);
    corner.y += kLegendRow;
  }
}

}  // namespace

std::string slice_picture(const Slice &slice) {
  const View overview = View::fit(overview_window(slice), {kMargin, kMargin}, kOverviewSide);
  const double right = kMargin + overview.frame.width + kGap;
  const View close_up = View::fit(close_up_window(slice, overview.window), {right, kMargin}, kCloseUpSide);
  const std::optional<Disk> example = search_example(slice, close_up.window);
  const Point legend{right, kMargin + kCloseUpSide + 44};
  const Point notes{right, legend.y + kLegendRow * static_cast<double>(slice.levels.size() + 1) + 12};
  const double width = right + kCloseUpSide + kMargin;
  const double height = std::max(kMargin + overview.frame.height, notes.y + 2 * kLegendRow) + kMargin;

  Svg svg(width, height);
  draw_panel(svg, slice, overview, overview_levels(slice));
  draw_panel(svg, slice, close_up, close_up_levels(slice));
  if (example) draw_search(svg, slice, close_up, *example);
  draw_frames(svg, overview, close_up);
  draw_legend(svg, slice, legend);
  draw_notes(svg, slice, overview.window, example.has_value(), notes);
  return svg.document();
}

}  // namespace draw
