// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/SectionDrawing.h"

#include "base/NumberText.h"

namespace handwheel {

namespace {

Eigen::Vector2d inPlane(const Vec3& p, const PlaneAxes& axes) {
  return {p.dot(axes.u), p.dot(axes.v)};
}

// A group of DXF: a code on one line, its value on the next.
std::string group(int code, const std::string& value) {
  return std::to_string(code) + "\n" + value + "\n";
}

}  // namespace

// The Y axis of SVG points down.
std::string svgOf(const Section& section, const Vec3& normal) {
  const PlaneAxes axes = axesOfPlane(normal);
  Eigen::AlignedBox2d box;
  std::string path;
  for (const SectionCurve& curve : section.curves) {
    char command = 'M';
    for (const Vec3& p : curve.points) {
      const Eigen::Vector2d q = inPlane(p, axes);
      box.extend(q);
      path += command + shortestText(q.x()) + "," + shortestText(-q.y()) + " ";
      command = 'L';
    }
    path += curve.closed ? "Z\n" : "\n";
  }
  if (box.isEmpty()) box.extend(Eigen::Vector2d::Zero());
  const std::string width = shortestText(box.sizes().x()), height = shortestText(box.sizes().y());
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" "
         "width=\"" +
         width + "mm\" height=\"" + height + "mm\" viewBox=\"" + shortestText(box.min().x()) + " " +
         shortestText(-box.max().y()) + " " + width + " " + height +
         "\">\n<path fill=\"none\" fill-rule=\"nonzero\" stroke=\"black\" stroke-width=\"0.1\" d=\"" + path +
         "\"/>\n</svg>\n";
}

std::string dxfOf(const Section& section, const Vec3& normal) {
  const PlaneAxes axes = axesOfPlane(normal);
  std::string text = group(0, "SECTION") + group(2, "HEADER") + group(9, "$ACADVER") + group(1, "AC1009") +
                     group(9, "$INSUNITS") + group(70, "4") + group(9, "$MEASUREMENT") + group(70, "1") +
                     group(0, "ENDSEC") + group(0, "SECTION") + group(2, "ENTITIES");
  const auto put = [&text](const Eigen::Vector2d& q) {
    text += group(10, shortestText(q.x())) + group(20, shortestText(q.y())) + group(30, "0.0");
  };
  for (const SectionCurve& curve : section.curves) {
    text += group(0, "POLYLINE") + group(8, "0") + group(66, "1") + group(70, curve.closed ? "1" : "0");
    put(Eigen::Vector2d::Zero());
    for (const Vec3& p : curve.points) {
      text += group(0, "VERTEX") + group(8, "0");
      put(inPlane(p, axes));
    }
    text += group(0, "SEQEND") + group(8, "0");
  }
  return text + group(0, "ENDSEC") + group(0, "EOF");
}

}  // namespace handwheel
