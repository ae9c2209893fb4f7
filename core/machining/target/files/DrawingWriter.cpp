// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/files/DrawingWriter.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kBeyondEnds = 5.0,
                 kPictureMargin = 5.0;  // mm, overrun of the axis beyond the part, and margin of the picture

// Appends the groups of a DXF file.
class DxfText {
 public:
  DxfText& group(int code, const std::string& value) {
    m_text += std::to_string(code) + "\n" + value + "\n";
    return *this;
  }
  DxfText& group(int code, double value) { return group(code, shortestText(value)); }
  DxfText& point(int code, const ProfilePoint& p) { return group(code, p.x()).group(code + 10, p.y()); }
  std::string take() { return std::move(m_text); }

 private:
  std::string m_text;
};

double degrees(const ProfilePoint& direction) {
  const double angle = std::atan2(direction.y(), direction.x()) * 180.0 / M_PI;
  return angle < 0.0 ? angle + 360.0 : angle;
}

// An arc of DXF turns counter-clockwise.
void addCurve(DxfText& dxf, const ProfileSegment& s) {
  if (!s.isArc()) {
    dxf.group(0, "LINE").group(8, "PROFILE").point(10, s.from).point(11, s.to);
    return;
  }
  const ProfileSegment ccw = s.bulge > 0.0 ? s : s.reversed();
  const ProfilePoint centre = ccw.centre();
  dxf.group(0, "ARC").group(8, "PROFILE").point(10, centre).group(40, ccw.radius());
  dxf.group(50, degrees(ccw.from - centre)).group(51, degrees(ccw.to - centre));
}

std::string pair(double x, double y) {
  return shortestText(x) + " " + shortestText(y);
}

}  // namespace

std::string dxfOf(const TargetProfile& target) {
  const Drawing drawing = drawingOf(target);
  DxfText dxf;
  dxf.group(0, "SECTION").group(2, "HEADER").group(9, "$ACADVER").group(1, "AC1009");
  dxf.group(9, "$INSUNITS").group(70, "4").group(9, "$MEASUREMENT").group(70, "1").group(0, "ENDSEC");
  dxf.group(0, "SECTION").group(2, "ENTITIES");
  for (const ProfileSegment& s : drawing.curves) addCurve(dxf, s);
  dxf.group(0, "LINE").group(8, "AXIS");
  dxf.point(10, {target.lowerEnd() - kBeyondEnds, 0.0}).point(11, {target.upperEnd() + kBeyondEnds, 0.0});
  dxf.group(0, "ENDSEC").group(0, "EOF");
  return dxf.take();
}

std::string svgOf(const TargetProfile& target) {
  const double left = target.lowerEnd() - kPictureMargin, top = -target.largestRadius() - kPictureMargin;
  const double width = target.length() + 2.0 * kPictureMargin, height = target.largestRadius() + 2.0 * kPictureMargin;
  std::string path;
  for (const ProfileSegment& s : drawingOf(target).curves) {
    if (path.empty()) path = "M " + pair(s.from.x(), -s.from.y());
    if (s.isArc()) {
      const std::string r = shortestText(s.radius());
      const bool isLarge = std::abs(s.angle()) > M_PI, isPositive = s.bulge < 0.0;  // y is down
      path.append(" A ").append(r).append(" ").append(r);
      path.append(isLarge ? " 0 1 " : " 0 0 ").append(isPositive ? "1 " : "0 ");
    } else {
      path += " L ";
    }
    path += pair(s.to.x(), -s.to.y());
  }
  const std::string size = " width=\"" + shortestText(width) + "mm\" height=\"" + shortestText(height) + "mm\"";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"" +
         size + " viewBox=\"" + pair(left, top) + " " + pair(width, height) +
         "\">\n <path id=\"profile\" fill=\"none\" stroke=\"black\" stroke-width=\"0.5\" d=\"" + path +
         "\"/>\n <line id=\"axis\" stroke=\"black\" stroke-width=\"0.25\" stroke-dasharray=\"8 2 1 2\" x1=\"" +
         shortestText(left) + "\" y1=\"0\" x2=\"" + shortestText(left + width) + "\" y2=\"0\"/>\n</svg>\n";
}

double distanceBetween(const TargetProfile& a, const TargetProfile& b) {
  constexpr int kSamples = 8;  // on each segment
  double largest = 0.0;
  const auto measure = [&](const TargetProfile& from, const TargetProfile& to) {
    for (const ProfileSegment& s : from.segments())
      for (int i = 0; i <= kSamples; ++i)
        largest = std::max(largest, std::abs(to.distance(s.at(static_cast<double>(i) / kSamples))));
  };
  measure(a, b);
  measure(b, a);
  return largest;
}

}  // namespace handwheel
