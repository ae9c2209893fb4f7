// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/Dimensions.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kText = 3.5;                       // mm, text height
constexpr double kTextGap = 1.0;                    // mm, between lines and texts
constexpr double kOverrun = 2.0;                    // mm, overrun of extension lines
constexpr double kArrowRoom = 8.0;                  // mm; longer dimensions have their arrows inside
constexpr double kArrowOutside = 6.0;               // mm, line behind outside arrows
constexpr double kRow = 8.0;                        // mm, between rows
constexpr double kNoteRow = 7.0;                    // mm
constexpr double kLeader = 9.0;                     // mm
constexpr double kSign = 4.5;                       // mm, width of the roughness sign
constexpr double kColumn = kText + 3.0 * kTextGap;  // mm, width of a text that runs up
constexpr std::size_t kMostRows = 7;                // more lengths are running dimensions

const ProfilePoint kUp(0, 1), kRight(1, 0);

}  // namespace

std::vector<double> spread(const std::vector<double>& wanted, double gap) {
  struct Pool {
    double sum;
    std::size_t count;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    pools.push_back({wanted[i] - gap * static_cast<double>(i), 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back() = {pools.back().sum + last.sum, pools.back().count + last.count};
    }
  }
  std::vector<double> positions;
  for (const Pool& pool : pools) {
    for (std::size_t k = 0; k < pool.count; ++k)
      positions.push_back(pool.mean() + gap * static_cast<double>(positions.size()));
  }
  return positions;
}

void DimensionLines::add(const PartDimensions& dimensions) {
  Notes notes = dimensions.notes;
  addDiameters(dimensions, notes);
  const double bottom = m_sheet.box().min().y(), top = m_layout.origin.y() + m_layout.scale * m_part.largestRadius();
  addLengths(dimensions.outerHeights, dimensions.spans, false, bottom);
  std::vector<double> inner = dimensions.innerHeights;
  if (!inner.empty()) inner.push_back(m_part.upperEnd());
  addNotes(std::move(notes), addLengths(std::move(inner), {}, true, top));
  clearLengthTexts();
}

void DimensionLines::addDiameters(const PartDimensions& dimensions, Notes& notes) {
  std::vector<double> taken;  // x of vertical lines
  for (const PartDimensions::Diameter& d : dimensions.diameters) {
    const double from = m_layout.at(0.0, d.low).x() + kText + kTextGap, to = m_layout.at(0.0, d.high).x() - kTextGap;
    const auto isFree = [&](double at) {
      return std::none_of(taken.begin(), taken.end(), [&](double t) { return std::abs(t - at) < kColumn; });
    };
    std::optional<double> x;
    for (const double share : {0.6, 0.35, 0.8, 0.2, 0.5, 0.9, 0.1}) {
      const double at = from + share * (to - from);
      if (!x && to >= from && isFree(at)) x = at;
    }
    if (x) {
      taken.push_back(*x);
      addDiameter(d, *x);
    } else {
      notes.push_back({{0.5 * d.value, 0.5 * (d.low + d.high)}, d.text});
    }
  }
}

// Draws a vertical line across the part, with the text beside it below the axis, where nothing is hatched, or below the
// part. In the half section a bore has one arrow, and the line ends beyond the axis (ISO 129-1).
void DimensionLines::addDiameter(const PartDimensions::Diameter& d, double x) {
  const double axis = m_layout.origin.y(), high = axis + 0.5 * m_layout.scale * d.value;
  const double low = 2.0 * axis - high, width = widthOf(d.text, kText);
  const bool isInside = high - low > 2.0 * kArrowRoom;
  double text = d.isInner ? axis - width - 2.0 * kTextGap : low + 4.0, bottom = d.isInner ? text - kTextGap : low;
  const bool hasRoom = d.isInner || (isInside && text + width + kTextGap < axis);
  if (!hasRoom) text = low - width - kArrowRoom, bottom = text - kTextGap;
  m_sheet.line({x, isInside ? high : high + kArrowOutside}, {x, bottom});
  m_sheet.arrow({x, high}, isInside ? kUp : ProfilePoint(-kUp));
  if (!d.isInner) m_sheet.arrow({x, low}, isInside ? ProfilePoint(-kUp) : kUp);
  m_sheet.texts.push_back({{x - kTextGap, text}, d.text, kText, Sheet::Align::Left, true});
}

// Draws an extension line from the surface to a line of dimensions.
void DimensionLines::extend(double z, double y, bool isAbove) {
  const auto extent = m_part.extentAt(z);
  const double r = extent ? extent->outer : 0.0;
  const ProfilePoint start = m_layout.at(isAbove ? r : -r, z);
  m_sheet.line({start.x(), start.y() + (isAbove ? kTextGap : -kTextGap)}, {start.x(), y});
}

void DimensionLines::addLength(const PartDimensions::Length& length, double y, bool isAbove) {
  const double a = m_layout.at(0.0, length.from).x(), b = m_layout.at(0.0, length.to).x();
  const double width = widthOf(length.text, kText);
  const bool isInside = b - a > 2.0 * kArrowRoom, hasRoom = b - a > width + 2.0 * kTextGap + (isInside ? 6.0 : 0.0);
  for (const double z : {length.from, length.to}) extend(z, y + (isAbove ? kOverrun : -kOverrun), isAbove);
  const double outside = isInside ? 0.0 : kArrowOutside;
  // A text without room inside goes to the right, where no extension line goes further out.
  m_sheet.line({a - outside, y}, {b + outside + (hasRoom ? 0.0 : width + 2.0 * kTextGap), y});
  m_sheet.arrow({a, y}, isInside ? ProfilePoint(-kRight) : kRight);
  m_sheet.arrow({b, y}, isInside ? kRight : ProfilePoint(-kRight));
  if (hasRoom) {
    if (isAbove) m_lengthTexts.push_back({m_sheet.texts.size(), a, b});
    return m_sheet.text({0.5 * (a + b), y + kTextGap}, length.text);
  }
  m_sheet.text({b + outside + kTextGap, y + kTextGap}, length.text, Sheet::Align::Left);
}

double DimensionLines::addLengths(std::vector<double> heights, const std::vector<PartDimensions::Length>& spans,
                                  bool isAbove, double start) {
  if (heights.size() < 2) return start;
  const double out = isAbove ? 1.0 : -1.0, end = heights.back();
  double y = start + out * (isAbove ? kRow : kRow + kText);
  std::vector<PartDimensions::Length> rows = spans;
  const bool isRunning = heights.size() - 1 + spans.size() > kMostRows;
  for (auto z = heights.rbegin() + 1; z != heights.rend() && !isRunning; ++z)
    rows.push_back({*z, end, toleratedText(m_title, DrawnTolerance::Of::Length, end - *z, *z, end, {})});
  for (const PartDimensions::Length& row : rows) {
    addLength(row, y, isAbove);
    y += out * kRow;
  }
  return isRunning ? addRunning(heights, isAbove, y) : y;
}

// Superimposed running dimensions (ISO 129-1): one line from the upper end, texts at the ends of the extension lines,
// which have a kink where their neighbours are too near.
double DimensionLines::addRunning(const std::vector<double>& heights, bool isAbove, double start) {
  constexpr double kKink = 6.0;  // mm
  const double out = isAbove ? 1.0 : -1.0, end = heights.back(), origin = m_layout.at(0.0, end).x();
  std::vector<double> wanted;
  double longest = 0.0;
  std::vector<std::string> texts;
  for (const double z : heights) {
    wanted.push_back(m_layout.at(0.0, z).x());
    texts.push_back(toleratedText(m_title, DrawnTolerance::Of::Length, end - z, z, end, {}));
    longest = std::max(longest, widthOf(texts.back(), kText));
  }
  const std::vector<double> positions = spread(wanted, kColumn);
  m_sheet.line({wanted.front(), start}, {origin, start});
  for (const double half : {M_PI, 2.0 * M_PI})
    m_sheet.strokes.push_back({arcAround({origin, start}, 1.0, half - M_PI, half), Sheet::Line::Narrow});
  for (std::size_t i = 0; i < heights.size(); ++i) {
    extend(heights[i], start + out * kTextGap, isAbove);
    if (i + 1 < heights.size()) m_sheet.arrow({wanted[i], start}, ProfilePoint(-kRight));
    const ProfilePoint kink(positions[i], start + out * kKink);
    m_sheet.line({wanted[i], start + out * kTextGap}, kink);
    m_sheet.line(kink, {kink.x(), kink.y() + out * (longest + kTextGap)});
    m_sheet.texts.push_back({{kink.x() - kTextGap, isAbove ? kink.y() + kTextGap : kink.y() - kTextGap},
                             texts[i],
                             kText,
                             isAbove ? Sheet::Align::Left : Sheet::Align::Right,
                             true});
  }
  return start + out * (kKink + longest + kRow);
}

// Leaders from the surface above the axis, outwards. From right to left, each in the lowest row where its text ends
// before the leaders and texts of the others: so no leader crosses a text.
void DimensionLines::addNotes(Notes notes, double first) {
  std::stable_sort(notes.begin(), notes.end(), [](const auto& a, const auto& b) { return a.at.y() > b.at.y(); });
  for (const PartDimensions::Note& note : notes) {
    const ProfilePoint tip = m_layout.at(note.at);
    const double x = tip.x() + kLeader;
    const double width = widthOf(note.text, kText) + (note.isRoughness ? kSign : 0.0) + 2.0 * kTextGap;
    double y = first + kTextGap;
    const auto isFree = [&] {
      return std::all_of(m_leaders.begin(), m_leaders.end(), [&](const Leader& other) {
        return other.elbow.y() < y - 0.5 * kNoteRow || x + width + kTextGap <= other.at(y);
      });
    };
    while (!isFree()) y += kNoteRow;
    m_leaders.push_back({tip, {x, y}});
    addNote(note, {x, y}, width);
  }
}

// Moves the texts of lengths above the part along their lines to where no leader crosses them.
void DimensionLines::clearLengthTexts() {
  for (const LengthText& each : m_lengthTexts) {
    Sheet::Text& text = m_sheet.texts[each.index];
    const double half = 0.5 * widthOf(text.text, text.height) + kTextGap;
    const auto isFree = [&](double x) {
      return std::none_of(m_leaders.begin(), m_leaders.end(), [&](const Leader& leader) {
        const double low = leader.at(text.at.y() - kTextGap), high = leader.at(text.at.y() + kText + kTextGap);
        return std::min(low, high) < x + half && std::max(low, high) > x - half;
      });
    };
    for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9, 0.0, 1.0}) {
      const double x = each.low + half + share * (each.high - each.low - 2.0 * half);
      if (!isFree(x)) continue;
      text.at.x() = x;
      break;
    }
  }
}

void DimensionLines::addNote(const PartDimensions::Note& note, const ProfilePoint& elbow, double width) {
  const ProfilePoint tip = m_layout.at(note.at);
  m_sheet.line(tip, elbow);
  m_sheet.line(elbow, {elbow.x() + width, elbow.y()});
  m_sheet.arrow(tip, tip - elbow);
  ProfilePoint text(elbow.x() + kTextGap, elbow.y() + kTextGap);
  if (note.isRoughness) {
    // The sign of ISO 21920-1 for a surface from which material is removed.
    const double left = 0.3 * kSign, right = 0.7 * kSign, low = elbow.y(), middle = low + 2.0, high = low + 4.0;
    m_sheet.line({text.x() + left, low}, {text.x(), middle});
    m_sheet.line({text.x() + left, low}, {text.x() + right, high});
    m_sheet.line({text.x(), middle}, {text.x() + 0.5 * right + 0.5 * left, middle});
    text.x() += kSign;
  }
  m_sheet.text(text, note.text, Sheet::Align::Left);
}

}  // namespace handwheel
