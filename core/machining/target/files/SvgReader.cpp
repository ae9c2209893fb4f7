// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/files/SvgReader.h"

#include "machining/target/TargetErrors.h"
#include "machining/target/files/SvgPath.h"
#include "xml/Xml.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kPixel = 25.4 / 96.0;  // mm
constexpr std::size_t kMostOtherNames = 100;

std::string_view localName(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

// Returns the millimetres of a unit of length; 0 if it depends on something else.
double millimetresOfUnit(std::string_view unit) {
  if (unit.empty() || unit == "px") return kPixel;
  if (unit == "mm") return 1.0;
  if (unit == "cm") return 10.0;
  if (unit == "in") return 25.4;
  if (unit == "pt") return 25.4 / 72.0;
  if (unit == "pc") return 25.4 / 6.0;
  if (unit == "Q" || unit == "q") return 0.25;
  return 0.0;
}

struct SvgLength {
  double value = 0.0;  // mm
  bool hasUnit = false;
};

std::optional<SvgLength> lengthOf(const XmlElement& element, std::string_view attribute) {
  const std::string* const text = element.attribute(attribute);
  if (!text) return std::nullopt;
  std::string_view rest = *text;
  double number = 0.0;
  if (!takeSvgNumber(rest, number)) return std::nullopt;
  while (!rest.empty() && rest.back() == ' ') rest.remove_suffix(1);
  const double unit = millimetresOfUnit(rest);
  if (!(unit > 0.0)) return std::nullopt;
  return SvgLength{number * unit, !rest.empty() && rest != "px"};
}

double numberIn(const XmlElement& element, std::string_view attribute) {
  const std::string* const text = element.attribute(attribute);
  std::string_view rest = text ? std::string_view(*text) : std::string_view();
  double number = 0.0;
  return takeSvgNumber(rest, number) ? number : 0.0;
}

bool isHidden(const XmlElement& element) {
  constexpr std::array kNotDrawn{"defs", "clipPath", "mask",  "symbol", "marker",   "pattern",
                                 "text", "title",    "style", "desc",   "metadata", "namedview"};
  const std::string_view name = localName(element.name);
  if (std::find(kNotDrawn.begin(), kNotDrawn.end(), name) != kNotDrawn.end()) return true;
  const std::string* const display = element.attribute("display");
  const std::string* const style = element.attribute("style");
  return (display && *display == "none") || (style && (style->find("display:none") != std::string::npos ||
                                                       style->find("display: none") != std::string::npos));
}

bool isNamedAxis(const XmlElement& element) {
  for (const XmlAttribute& a : element.attributes) {
    const std::string_view name = localName(a.name);
    if ((name == "id" || name == "class" || name == "label") && a.value == "axis") return true;
  }
  return false;
}

// Returns the transformation from user units to mm, with y flipped to point up.
Eigen::Affine2d millimetresOf(const XmlElement& root, bool& hasUnit) {
  const auto width = lengthOf(root, "width"), height = lengthOf(root, "height");
  hasUnit = (width && width->hasUnit) || (height && height->hasUnit);
  double scale = kPixel;
  std::array<double, 4> box{};
  if (const std::string* const text = root.attribute("viewBox")) {
    std::string_view rest = *text;
    std::size_t count = 0;
    while (count < box.size() && takeSvgNumber(rest, box[count])) ++count;
    // By default the whole box is shown, with one scale.
    double fit = HUGE_VAL;
    if (count == box.size() && width && box[2] > 0.0) fit = std::min(fit, width->value / box[2]);
    if (count == box.size() && height && box[3] > 0.0) fit = std::min(fit, height->value / box[3]);
    if (std::isfinite(fit) && fit > 0.0) scale = fit;
  }
  Eigen::Affine2d to = Eigen::Affine2d::Identity();
  to.scale(Eigen::Vector2d(scale, -scale));
  return to;
}

// Reads the elements of a drawing.
class SvgWalk {
 public:
  SvgWalk(Drawing& drawing, Progress progress) : m_drawing(drawing), m_progress(progress) {}

  Status visit(const XmlElement& element, const SvgCurves& parent, bool isAxis) {
    if (m_progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (isHidden(element)) return Done{};
    SvgCurves here = parent;
    if (const std::string* const transform = element.attribute("transform")) {
      const Result<Eigen::Affine2d> inner = readSvgTransform(*transform);
      if (!inner) return inner.error();
      here = parent.under(*inner);
    }
    isAxis = isAxis || isNamedAxis(element);
    if (const Status drawn = draw(element, here); !drawn) return drawn;
    if (const Status kept = keep(here.found(), isAxis); !kept) return kept;
    here.found().clear();
    for (const XmlElement& child : element.children)
      if (const Status visited = visit(child, here, isAxis); !visited) return visited;
    return Done{};
  }

 private:
  Status draw(const XmlElement& element, SvgCurves& curves) {
    const std::string_view name = localName(element.name);
    const auto number = [&](const char* attribute) { return numberIn(element, attribute); };
    if (name == "path") {
      const std::string* const d = element.attribute("d");
      return d ? readSvgPath(*d, TargetProfile::kMostSegments, curves, m_progress) : Status(Done{});
    }
    if (name == "line") {
      curves.line({number("x1"), number("y1")}, {number("x2"), number("y2")});
    } else if (name == "polyline" || name == "polygon") {
      polyline(element, name == "polygon", curves);
    } else if (name == "rect") {
      rectangle(element, curves);
    } else if (name == "circle" || name == "ellipse") {
      const double rx = number(name == "circle" ? "r" : "rx"), ry = number(name == "circle" ? "r" : "ry");
      if (rx > 0.0 && ry > 0.0) {
        for (const double from : {0.0, M_PI}) curves.arc({number("cx"), number("cy")}, rx, ry, 0.0, from, M_PI);
      }
    } else if (name != "svg" && name != "g" && name != "a" && m_drawing.others.size() < kMostOtherNames) {
      ++m_drawing.others[std::string(name.substr(0, 40))];
    }
    return Done{};
  }
  // The corners are quarters of an ellipse. One of the half axes may be left out, and neither is more than half a side.
  static void rectangle(const XmlElement& element, SvgCurves& curves) {
    const ProfilePoint at(numberIn(element, "x"), numberIn(element, "y"));
    const ProfilePoint size(numberIn(element, "width"), numberIn(element, "height"));
    const auto given = [&](const char* name) -> std::optional<double> {
      const std::string* const text = element.attribute(name);
      std::string_view rest = text ? std::string_view(*text) : std::string_view();
      double number = 0.0;
      return takeSvgNumber(rest, number) && number >= 0.0 ? std::optional(number) : std::nullopt;
    };
    const std::optional<double> x = given("rx"), y = given("ry");
    const double rx = std::min(x.value_or(y.value_or(0.0)), 0.5 * size.x());
    const double ry = std::min(y.value_or(x.value_or(0.0)), 0.5 * size.y());
    const bool isRound = rx > 0.0 && ry > 0.0;
    const ProfilePoint in = isRound ? ProfilePoint(rx, ry) : ProfilePoint(0.0, 0.0), end = at + size;
    const std::array centres{ProfilePoint(end.x() - in.x(), at.y() + in.y()), ProfilePoint(end - in),
                             ProfilePoint(at.x() + in.x(), end.y() - in.y()), ProfilePoint(at + in)};
    const auto onArc = [&](std::size_t corner, double angle) {
      return ProfilePoint(centres[corner] + ProfilePoint(in.x() * std::cos(angle), in.y() * std::sin(angle)));
    };
    for (std::size_t i = 0; i < 4; ++i) {
      const double begin = 0.5 * M_PI * (static_cast<double>(i) - 1.0);
      if (isRound) curves.arc(centres[i], rx, ry, 0.0, begin, 0.5 * M_PI);
      curves.line(onArc(i, begin + 0.5 * M_PI), onArc((i + 1) % 4, begin + 0.5 * M_PI));
    }
  }
  void polyline(const XmlElement& element, bool isClosed, SvgCurves& curves) {
    const std::string* const text = element.attribute("points");
    std::string_view rest = text ? std::string_view(*text) : std::string_view();
    std::vector<ProfilePoint> points;
    for (double x = 0.0, y = 0.0; takeSvgNumber(rest, x) && takeSvgNumber(rest, y);) points.emplace_back(x, y);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) curves.line(points[i], points[i + 1]);
    if (isClosed && points.size() > 2) curves.line(points.back(), points.front());
  }
  Status keep(const std::vector<ProfileSegment>& curves, bool isAxis) {
    for (const ProfileSegment& s : curves) {
      if (!s.from.allFinite() || !s.to.allFinite())
        return Error{ErrorCode::ElementMalformed, {"path", "a coordinate is too large"}, {}, {}};
      const bool isLevel = !s.isArc() && std::abs(s.to.y() - s.from.y()) <= 1e-6 * s.length();
      if (isAxis && isLevel) m_drawing.axis = s.from.y();
      if (!isAxis) m_drawing.curves.push_back(s);
    }
    if (m_drawing.curves.size() <= TargetProfile::kMostSegments) return Done{};
    return Error{ErrorCode::FileTooLarge, {"segments", "", std::to_string(TargetProfile::kMostSegments)}, {}, {}};
  }

  Drawing& m_drawing;
  Progress m_progress;
};

// Returns the height of the lowest straight line, if nothing is below it: the line that closes the half section.
std::optional<double> lowestLine(const std::vector<ProfileSegment>& curves) {
  double lowest = HUGE_VAL, line = HUGE_VAL;
  for (const ProfileSegment& s : curves) {
    lowest = std::min(lowest, s.box().min().y());
    const bool isLevel = !s.isArc() && std::abs(s.to.y() - s.from.y()) <= kDrawingGap;
    if (isLevel) line = std::min(line, s.from.y());
  }
  return line <= lowest + kDrawingGap ? std::optional<double>(line) : std::nullopt;
}

}  // namespace

bool looksLikeSvg(std::string_view head) {
  const std::size_t first = head.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  if (first == head.npos || head[first] != '<') return false;
  for (const std::string_view start : {"<svg", "<svg:svg"})
    if (head.find(start) != head.npos) return true;
  return false;
}

Result<Drawing> readSvg(std::string_view bytes, Progress progress) {
  const Result<XmlElement> root = readXml(bytes, {}, progress.part(0.0, 0.5));
  if (!root) return root.error();
  if (localName(root->name) != "svg") return malformed(*root, "an element svg was expected");
  Drawing drawing;
  const SvgCurves curves(millimetresOf(*root, drawing.hasUnit));
  SvgWalk walk(drawing, progress.part(0.5, 1.0));
  if (const Status visited = walk.visit(*root, curves, false); !visited) return visited.error();
  if (drawing.curves.empty()) return Error{TargetError::NoProfile, {}, {}, {}};
  if (!drawing.axis) drawing.axis = lowestLine(drawing.curves);
  if (!drawing.axis) return Error{TargetError::AxisUnknown, {}, {}, {}};
  return drawing;
}

}  // namespace handwheel
