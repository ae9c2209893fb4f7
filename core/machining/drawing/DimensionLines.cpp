// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/Dimensions.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kText = 3.5;       // mm, height
constexpr double kGap = 1.0;        // mm, between lines and texts
constexpr double kOverrun = 2.0;    // mm, of extension lines
constexpr double kArrowRoom = 8.0;  // mm: arrows are inside of what is longer
constexpr double kLeader = 9.0;     // mm

const ProfilePoint kUp(0, 1), kRight(1, 0);

}  // namespace

std::string DimensionLines::withTolerance(DrawnTolerance::Of of, double value) const {
  constexpr double kNominal = 0.051;  // mm: a part is not exactly what was asked
  for (const DrawnTolerance& t : m_title.tolerances)
    if (t.of == of && std::abs(t.size - value) < kNominal) return sizeText(t.size) + " " + t.text;
  return sizeText(value);
}

// A vertical line across the part, the text beside it below the axis, where nothing is hatched.
void DimensionLines::addDiameters(const PartDimensions& dimensions) {
  std::vector<double> taken;  // x of lines
  for (const PartDimensions::Diameter& d : dimensions.diameters) {
    const double r = 0.5 * d.value;
    const ProfilePoint low = m_place.at(-r, 0.0), high = m_place.at(r, 0.0);
    const double from = m_place.at(0.0, d.low).x(), to = m_place.at(0.0, d.high).x();
    double x = d.low == d.high ? from : from + (d.isInner ? 0.35 : 0.6) * (to - from);
    const auto isFree = [&](double at) {
      return std::none_of(taken.begin(), taken.end(), [&](double t) { return std::abs(t - at) < kText + 2.0 * kGap; });
    };
    for (double step = 0.0; !isFree(x) && step < 60.0; step += 3.0) x += x + 3.0 < to ? 3.0 : -3.0;
    taken.push_back(x);
    const std::string text = "Ø" + withTolerance(DrawnTolerance::Of::Diameter, d.value);
    const double width = widthOf(text, kText), tall = high.y() - low.y();
    const bool isInside = tall > 2.0 * kArrowRoom;
    const bool hasRoom = 0.5 * tall > width + 2.0 * kArrowRoom - 6.0;
    const double bottom = hasRoom ? low.y() : low.y() - width - kArrowRoom;
    m_sheet.line({x, isInside ? high.y() : high.y() + kArrowRoom}, {x, bottom});
    if (x < std::min(from, to) || x > std::max(from, to)) {
      m_sheet.line({x, high.y()}, {to, high.y()});
      m_sheet.line({x, low.y()}, {to, low.y()});
    }
    m_sheet.arrow({x, high.y()}, isInside ? kUp : ProfilePoint(-kUp));
    m_sheet.arrow({x, low.y()}, isInside ? ProfilePoint(-kUp) : kUp);
    const double textY = hasRoom ? low.y() + 4.0 : low.y() - width - kArrowRoom + kGap;
    m_sheet.texts.push_back({{x - kGap, textY}, text, kText, Sheet::Align::Left, true});
  }
}

double DimensionLines::roomFor(std::size_t heights) {
  if (heights < 2) return 0.0;
  const std::size_t rows = heights - 1 <= kMostRows ? heights - 1 : 2;
  return kFirstRow + kRow * static_cast<double>(rows);
}

void DimensionLines::addLength(double from, double to, double y, bool isAbove) {
  const double a = m_place.at(0.0, from).x(), b = m_place.at(0.0, to).x();
  const std::string text = withTolerance(DrawnTolerance::Of::Length, to - from);
  const double width = widthOf(text, kText);
  const bool isInside = b - a > kArrowRoom;
  const bool hasRoom = b - a > width + 2.0 * kGap + (isInside ? 6.0 : 0.0);
  const double edge = isAbove ? kOverrun : -kOverrun;
  for (const auto& [x, z] : {std::pair{a, from}, std::pair{b, to}}) {
    const auto extent = m_part.extentAt(z);
    const double r = extent ? extent->outer : 0.0;
    const double start = m_place.at(isAbove ? r : -r, z).y() + (isAbove ? kGap : -kGap);
    m_sheet.line({x, start}, {x, y + edge});
  }
  const double outside = isInside ? 0.0 : 6.0;
  m_sheet.line({a - outside - (hasRoom ? 0.0 : width + kGap), y}, {b + outside, y});
  m_sheet.arrow({a, y}, isInside ? ProfilePoint(-kRight) : kRight);
  m_sheet.arrow({b, y}, isInside ? kRight : ProfilePoint(-kRight));
  const double middle = hasRoom ? 0.5 * (a + b) : a - outside - 0.5 * (width + kGap);
  m_sheet.text({middle, y + kGap}, text);
}

// From the upper end, the shortest nearest to the part; where there are many, as a chain with the whole below.
void DimensionLines::addLengths(const std::vector<double>& heights, bool isAbove) {
  if (heights.size() < 2) return;
  const double beyond = m_place.scale * m_part.largestRadius();
  const auto row = [&](std::size_t i) {
    const double away = beyond + kFirstRow + kRow * static_cast<double>(i);
    return m_place.origin.y() + (isAbove ? away : -away);
  };
  const double end = heights.back();
  if (heights.size() - 1 <= kMostRows) {
    std::size_t i = 0;
    for (auto z = heights.rbegin() + 1; z != heights.rend(); ++z) addLength(*z, end, row(i++), isAbove);
    return;
  }
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) addLength(heights[i], heights[i + 1], row(0), isAbove);
  addLength(heights.front(), end, row(1), isAbove);
}

// Leaders from the surface above the axis, outwards; their texts keep clear of one another.
void DimensionLines::addNotes(const PartDimensions& dimensions) {
  const double beyond = m_place.origin.y() + m_place.scale * m_part.largestRadius();
  const double first = beyond + 5.0 + roomFor(dimensions.innerHeights.empty() ? 0 : dimensions.innerHeights.size() + 1);
  std::vector<PartDimensions::Note> notes = dimensions.notes;
  std::sort(notes.begin(), notes.end(), [](const auto& a, const auto& b) { return a.at.y() < b.at.y(); });
  std::vector<double> rowEnds;  // x up to which each row of texts is taken
  for (const PartDimensions::Note& note : notes) {
    const ProfilePoint tip = m_place.at(note.at);
    const double width = widthOf(note.text, kText), x = tip.x() + kLeader;
    std::size_t row = 0;
    while (row < rowEnds.size() && rowEnds[row] > x - kGap) ++row;
    if (row == rowEnds.size()) rowEnds.push_back(0.0);
    rowEnds[row] = x + width + 2.0 * kGap;
    const ProfilePoint elbow(x, first + 6.0 * static_cast<double>(row));
    m_sheet.line(tip, elbow);
    m_sheet.line(elbow, {x + width + kGap, elbow.y()});
    m_sheet.arrow(tip, tip - elbow);
    m_sheet.text({x + kGap, elbow.y() + kGap}, note.text, Sheet::Align::Left);
  }
}

}  // namespace handwheel
