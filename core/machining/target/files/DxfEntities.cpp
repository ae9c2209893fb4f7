// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/files/DxfEntities.h"

#include "base/Units.h"
#include "machining/target/CurveFit.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

using Segments = std::vector<ProfileSegment>;

constexpr int kClosed = 1, kInSpace = 8 | 16 | 64;  // flags of polylines
constexpr int kFrameVertex = 16;

std::string lowered(std::string_view text) {
  std::string low(text);
  for (char& c : low) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return low;
}

Error malformedEntity(const DxfEntity& entity, const char* what) {
  return {ErrorCode::ElementMalformed, {entity.type, what}, InputPosition::line(entity.line), {}};
}

// Returns arcs counter-clockwise, as two halves if it is more than half a circle.
Segments arcs(const ProfilePoint& centre, double radius, double from, double sweep) {
  if (sweep <= M_PI) return {arcAround(centre, radius, from, from + sweep)};
  const double middle = from + 0.5 * sweep;
  Segments halves{arcAround(centre, radius, from, middle), arcAround(centre, radius, middle, from + sweep)};
  if (sweep == 2.0 * M_PI) halves[1].to = halves[0].from;
  return halves;
}

// Returns the sweep from one angle to the other, more than 0 and at most 2π.
double sweepBetween(double from, double to) {
  const double sweep = std::fmod(to - from, 2.0 * M_PI);
  return sweep > 0.0 ? sweep : sweep + 2.0 * M_PI;
}

Segments ellipse(const DxfEntity& entity, double tolerance) {
  // Its points are not in the plane of the entity, but the minor axis is across the major one about its normal.
  const double about = entity.normalZ < 0.0 ? -entity.size : entity.size;
  const ProfilePoint major = entity.second, minor = about * ProfilePoint(-major.y(), major.x());
  const double sweep = sweepBetween(entity.span[0], entity.span[1]);
  const auto curve = [&](double t) {
    const double angle = entity.span[0] + t * sweep;
    return ProfilePoint(entity.first + std::cos(angle) * major + std::sin(angle) * minor);
  };
  return fitSegments(curve, tolerance);
}

Segments polyline(const DxfEntity& entity) {
  Segments all;
  std::vector<DxfEntity::Vertex> on;
  std::copy_if(entity.vertices.begin(), entity.vertices.end(), std::back_inserter(on),
               [](const DxfEntity::Vertex& v) { return !v.isFrame; });
  const bool isClosed = (entity.flags & kClosed) != 0;
  for (std::size_t i = 0; i + (isClosed ? 0 : 1) < on.size(); ++i) {
    const DxfEntity::Vertex& next = on[(i + 1) % on.size()];
    if (next.at != on[i].at) all.push_back({on[i].at, next.at, on[i].bulge});
  }
  return all;
}

void mirrorX(Segments& all) {
  for (ProfileSegment& s : all) {
    s.from.x() = -s.from.x();
    s.to.x() = -s.to.x();
    s.bulge = -s.bulge;
  }
}

}  // namespace

Status DxfEntity::take(const DxfPair& pair) {
  if (pair.code == 8) layer = lowered(pair.value);
  if (pair.code == 6) lineType = lowered(pair.value);
  if (pair.code == 67 || pair.code == 60) isShown = isShown && pair.whole() == 0;
  if (pair.code == 70 && type != "VERTEX") flags = pair.whole();
  if (pair.code == 70 && type == "VERTEX" && !vertices.empty())
    vertices.back().isFrame = (pair.whole() & kFrameVertex) != 0;
  constexpr std::array kNumbers{10, 11, 20, 21, 40, 41, 42, 50, 51, 210, 220, 230};
  if (std::find(kNumbers.begin(), kNumbers.end(), pair.code) == kNumbers.end()) return Done{};
  const Result<double> number = pair.number();
  if (!number) return number.error();
  const bool hasVertices = type == "LWPOLYLINE" || type == "VERTEX";
  if (pair.code == 10 && type == "LWPOLYLINE") vertices.emplace_back();
  DxfEntity::Vertex* const vertex = hasVertices && !vertices.empty() ? &vertices.back() : nullptr;
  if (pair.code == 10) (vertex ? vertex->at : first).x() = *number;
  if (pair.code == 20) (vertex ? vertex->at : first).y() = *number;
  if (pair.code == 42 && vertex) vertex->bulge = *number;
  if (pair.code == 11) second.x() = *number;
  if (pair.code == 21) second.y() = *number;
  if (pair.code == 40) size = *number;
  if (pair.code == 41 || (pair.code == 42 && !vertex)) span[pair.code == 41 ? 0 : 1] = *number;
  if (pair.code == 50 || pair.code == 51) span[pair.code == 50 ? 0 : 1] = *number * kRadiansPerDegree;
  if (pair.code == 210) tilt.x() = *number;
  if (pair.code == 220) tilt.y() = *number;
  if (pair.code == 230) normalZ = *number;
  return Done{};
}

bool DxfEntity::isAxis() const {
  if (type != "LINE" && type != "LWPOLYLINE" && type != "POLYLINE") return false;
  constexpr std::array kLayers{"axis", "center", "centre", "centerline", "centreline", "achse", "mittellinie"};
  return std::find(kLayers.begin(), kLayers.end(), layer) != kLayers.end() || lineType.starts_with("center") ||
         lineType.starts_with("centre");
}

bool DxfEntity::isRead() const {
  constexpr std::array kRead{"LINE", "ARC", "CIRCLE", "ELLIPSE", "LWPOLYLINE", "POLYLINE"};
  const bool isFlat = tilt.norm() <= 1e-9;
  return isFlat && std::find(kRead.begin(), kRead.end(), type) != kRead.end() &&
         !(type == "POLYLINE" && (flags & kInSpace) != 0);
}

Result<std::vector<ProfileSegment>> curvesOf(const DxfEntity& entity, double tolerance) {
  Segments all;
  if (entity.type == "LINE") {
    if (entity.first != entity.second) all.push_back({entity.first, entity.second, 0.0});
    return all;  // its points are not in the plane of an entity
  }
  if (entity.type == "ARC" || entity.type == "CIRCLE") {
    if (!(entity.size > 0.0)) return malformedEntity(entity, "its radius is not above zero");
    const bool isArc = entity.type == "ARC";
    const double sweep = isArc ? sweepBetween(entity.span[0], entity.span[1]) : 2.0 * M_PI;
    all = arcs(entity.first, entity.size, isArc ? entity.span[0] : 0.0, sweep);
  } else if (entity.type == "ELLIPSE") {
    if (!(entity.second.norm() > 0.0) || !(entity.size > 0.0)) return malformedEntity(entity, "it has no extent");
    all = ellipse(entity, tolerance);
    return all;
  } else {
    all = polyline(entity);
  }
  if (entity.normalZ < 0.0) mirrorX(all);
  return all;
}

}  // namespace handwheel
