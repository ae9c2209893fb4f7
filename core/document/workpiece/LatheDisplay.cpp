// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/LatheDisplay.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

using Shape = std::shared_ptr<const TriangleSoup>;
using Colour = std::array<float, 3>;

constexpr Colour kSteel{0.55f, 0.57f, 0.60f}, kJawColour{0.42f, 0.44f, 0.48f}, kHolderColour{0.28f, 0.30f, 0.34f},
    kInsertColour{0.85f, 0.68f, 0.25f}, kPostColour{0.36f, 0.40f, 0.46f}, kAbrasiveColour{0.60f, 0.36f, 0.30f};
constexpr int kOutlineSides = 64, kRingSides = 48;

// The half of an outline on the side of r ≥ 0, from z to z, to be turned about the axis.
std::vector<ProfilePoint> upperHalf(const RoundedPolygon& section) {
  std::vector<ProfilePoint> half;
  const std::vector<ProfilePoint> line = section.outline(kOutlineSides);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const ProfilePoint &a = line[i], &b = line[i + 1];
    if (a.x() >= 0.0) half.push_back(a);
    if ((a.x() < 0.0) == (b.x() < 0.0)) continue;
    half.emplace_back(0.0, a.y() + (b.y() - a.y()) * a.x() / (a.x() - b.x()));
  }
  return half;
}

// A closed polygon in (r, z), counterclockwise with z to the right and r up, turned about the axis.
Shape turned(const std::vector<ProfilePoint>& polygon) {
  auto soup = std::make_shared<TriangleSoup>();
  const auto count = static_cast<std::uint32_t>(polygon.size());
  for (int k = 0; k < kRingSides; ++k) {
    const double angle = 2.0 * M_PI * k / kRingSides;
    for (const ProfilePoint& p : polygon)
      soup->points.emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
  }
  for (std::uint32_t k = 0; k < kRingSides; ++k) {
    const std::uint32_t here = k * count, there = (k + 1) % kRingSides * count;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next = (i + 1) % count;
      if (!(polygon[i].x() > 0.0 || polygon[next].x() > 0.0)) continue;
      if (polygon[i].x() > 0.0) soup->triangles.push_back({here + i, there + i, here + next});
      if (polygon[next].x() > 0.0) soup->triangles.push_back({here + next, there + i, there + next});
    }
  }
  return soup;
}

// A convex polygon in (r, z) as a plate in the plane of x and z, from y = low to high.
Shape extruded(std::vector<ProfilePoint> polygon, double low, double high) {
  auto soup = std::make_shared<TriangleSoup>();
  if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  const auto count = static_cast<std::uint32_t>(polygon.size());
  for (const double y : {low, high}) {
    for (const ProfilePoint& p : polygon) soup->points.emplace_back(p.x(), y, p.y());
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    soup->triangles.push_back({i, i + count, next});
    soup->triangles.push_back({next, i + count, next + count});
    if (i < 2) continue;
    soup->triangles.push_back({0, i - 1, i});
    soup->triangles.push_back({count, count + i, count + i - 1});
  }
  return soup;
}

DisplayPart partOfLathe(std::string name, Shape soup, const Colour& colour, bool isSmooth) {
  DisplayPart part;
  part.name = std::move(name);
  part.soup = std::move(soup);
  part.colour = colour;
  part.smooth = isSmooth;
  return part;
}

std::vector<ProfilePoint> boxAround(const RoundedPolygon& section) {
  std::vector<ProfilePoint> line = section.outline(kOutlineSides);
  return line;
}

}  // namespace

LatheDisplay::LatheDisplay(const LatheSetup& setup, const LatheTools& tools, double gripped, double base)
    : m_base(base) {
  for (const LatheSolid& solid : chuckSolids(setup.chuck, gripped)) {
    if (solid.part == LathePart::Chuck) {
      m_chuck.push_back(partOfLathe("lathe.chuck", turned(upperHalf(solid.section)), kSteel, true));
    } else if (m_chuck.size() < 2) {  // the section of the jaws is there twice
      const double half = 0.5 * setup.chuck.jawWidth;
      const Shape jaw = extruded(boxAround(solid.section), -half, half);
      for (int i = 0; i < 3; ++i) {
        m_chuck.push_back(partOfLathe("lathe.jaw." + std::to_string(i), jaw, kJawColour, false));
        m_chuck.back().pose.rotate(Eigen::AngleAxisd(2.0 * M_PI * i / 3.0, Vec3::UnitZ()));
      }
    }
  }
  const auto drill = toolNamed(tools, setup.tailstock.drill);
  int number = 0;
  for (const LatheSolid& solid : tailstockSolids(setup.tailstock, 0.0, drill.get())) {
    const std::string name = "lathe.tailstock." + std::to_string(number++);
    auto& list = solid.part == LathePart::Tailstock ? m_tailstock : m_quill;
    list.push_back(partOfLathe(name, turned(upperHalf(solid.section)), kSteel, true));
    list.back().isSectioned = false;
  }
  for (DisplayPart& part : m_tailstock) part.pose.translation().z() = base;
  for (const LatheSlot& slot : setup.stations) {
    if (const auto tool = toolNamed(tools, slot.tool)) m_tools.emplace(tool->id, toolParts(*tool));
  }
}

std::vector<DisplayPart> LatheDisplay::toolParts(const LatheTool& tool) const {
  constexpr double kInsertHeight = 4.76, kShankHeight = 20.0, kDiskHeight = 100.0, kPostHeight = 30.0;  // mm
  std::vector<DisplayPart> parts;
  int number = 0;
  for (const LatheSolid& solid : toolSolids(tool)) {
    const std::string name = "lathe.tool." + std::to_string(number++);
    const bool isDisk = tool.kind == LatheToolKind::GrindingDisk && solid.part == LathePart::CuttingEdge;
    switch (solid.part) {
      case LathePart::CuttingEdge:
        parts.push_back(
            partOfLathe(name,
                        isDisk ? extruded(solid.section.outline(kOutlineSides), -0.5 * kDiskHeight, 0.5 * kDiskHeight)
                               : extruded(solid.section.outline(kOutlineSides), -kInsertHeight, 0.0),
                        tool.isAbrasive() ? kAbrasiveColour : kInsertColour, false));
        break;
      case LathePart::Holder:
        parts.push_back(partOfLathe(name, extruded(solid.section.outline(kOutlineSides), -kShankHeight, -0.1),
                                    kHolderColour, false));
        break;
      case LathePart::ToolPost:
        parts.push_back(
            partOfLathe(name, extruded(solid.section.outline(kOutlineSides), -kPostHeight, 15.0), kPostColour, false));
        break;
      default:  // the slides below would hide the work
        break;
    }
  }
  for (DisplayPart& part : parts) part.isSectioned = false;
  return parts;
}

std::vector<DisplayPart> LatheDisplay::parts(double turns, const ProfilePoint& tip, const LatheTool* tool,
                                             double quillTip) const {
  std::vector<DisplayPart> all;
  const Pose spindle = Eigen::Translation3d(0.0, 0.0, m_base) *
                       Pose(Eigen::AngleAxisd(2.0 * M_PI * (turns - std::floor(turns)), Vec3::UnitZ()));
  for (DisplayPart part : m_chuck) {
    part.pose = spindle * part.pose;
    all.push_back(std::move(part));
  }
  for (DisplayPart part : m_quill) {
    part.pose.translation().z() = m_base + quillTip;
    all.push_back(std::move(part));
  }
  all.insert(all.end(), m_tailstock.begin(), m_tailstock.end());
  const auto found = tool ? m_tools.find(tool->id) : m_tools.end();
  if (found == m_tools.end()) return all;
  for (DisplayPart part : found->second) {
    part.pose.translation() = Vec3(tip.x(), 0.0, tip.y() + m_base);
    all.push_back(std::move(part));
  }
  return all;
}

std::vector<std::vector<Vec3>> LatheDisplay::tipMark(const ProfilePoint& tip) const {
  constexpr double kArm = 3.0;  // mm
  const Vec3 at(tip.x(), 0.0, tip.y() + m_base);
  return {{at - kArm * Vec3::UnitX(), at + kArm * Vec3::UnitX()},
          {at - kArm * Vec3::UnitZ(), at + kArm * Vec3::UnitZ()}};
}

std::vector<std::vector<Vec3>> LatheDisplay::outline(const LatheTool& tool, const ProfilePoint& tip) const {
  std::vector<std::vector<Vec3>> lines;
  const auto draw = [&](const RoundedPolygon& section) {
    std::vector<Vec3> line;
    for (const ProfilePoint& p : section.outline(kOutlineSides))
      line.emplace_back(tip.x() + p.x(), 0.0, tip.y() + p.y() + m_base);
    lines.push_back(std::move(line));
  };
  for (const RoundedPolygon& section : tool.cutting) draw(section);
  const ProfilePoint centre = tool.noseCentre();
  if (tool.noseRadius > 0.0) draw(RoundedPolygon({&centre, 1}, tool.noseRadius));
  return lines;
}

}  // namespace handwheel
