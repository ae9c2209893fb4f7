// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/document/GlobeGeometry.h"

#include "document/container/ArchiveErrors.h"
#include "document/container/Blobs.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel::test {

namespace {

nlohmann::json write(const BodyGeometry& geometry, const std::string& folder, Container& container) {
  const GlobeSurface& points = dynamic_cast<const GlobeGeometry&>(geometry).points();
  std::vector<double> dents(kGlobePoints);
  for (std::size_t i = 0; i < kGlobePoints; ++i) dents[i] = points.dent(i);
  writeArray<double>(container, folder + "/dents", dents);
  return {{"radius", points.radius()}};
}

Result<GeometryPointer> read(const nlohmann::json& described, const std::string& folder, const Container& container,
                             std::vector<Error>& damage) {
  const auto found = described.find("radius");
  const double radius = found != described.end() && found->is_number() ? found->get<double>() : 0.0;
  const Error damaged{ArchiveError::EntryDamaged, {folder}, {}, {}};
  if (!isRadius(radius)) return damaged;
  GlobeSurface points(radius);
  const ReadArray<double> dents = readArray<double>(container, folder + "/dents", kGlobePoints);
  for (std::size_t i = 0; i < std::min(dents.values.size(), kGlobePoints); ++i) {
    if (dents.values[i] > 0.0) points.setDent(i, dents.values[i]);
  }
  if (!dents.lost.empty()) damage.push_back(damaged);
  return GeometryPointer(std::make_shared<const GlobeGeometry>(std::move(points)));
}

}  // namespace

const GeometryFormat kGlobeFormat = {GlobeGeometry::kKind, write, read};

std::shared_ptr<const TriangleSoup> GlobeGeometry::makeSurface() const {
  TriangleSoup soup;
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    for (const double side : {1.0, -1.0}) soup.points.push_back(side * m_points.heightTowards(side * axis) * axis);
  }
  soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return std::make_shared<const TriangleSoup>(std::move(soup));
}

}  // namespace handwheel::test
