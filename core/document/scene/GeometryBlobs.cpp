// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/GeometryBlobs.h"

#include "base/JsonText.h"
#include "document/container/ArchiveErrors.h"
#include "document/container/Blobs.h"
#include "document/scene/SurfaceBlobs.h"
#include "scene/MeshGeometry.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RevolvedGeometry.h"
#include "scene/UnknownGeometry.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using nlohmann::json;

json writeMesh(const BodyGeometry& geometry, const std::string& folder, Container& container) {
  return writeSoupBlobs<double>(dynamic_cast<const MeshGeometry&>(geometry).soup(), folder, container);
}

Result<GeometryPointer> readMesh(const json& described, const std::string& folder, const Container& container,
                                 std::vector<Error>& damage) {
  std::uint64_t lost = 0;
  TriangleSoup soup = readSoupBlobs<double>(described, folder, container, MeshGeometry::kLargestCoordinate, lost);
  const Error damaged{ArchiveError::EntryDamaged, {folder}, {}, {}};
  if (soup.triangles.empty()) return damaged;
  if (lost > 0) damage.push_back(damaged);
  return GeometryPointer(std::make_shared<const MeshGeometry>(std::move(soup)));
}

json writeRevolved(const BodyGeometry& geometry, const std::string& folder, Container& container) {
  const auto& revolved = dynamic_cast<const RevolvedGeometry&>(geometry);
  const ProfileNurbs& nurbs = revolved.profile().nurbs();
  std::vector<double> poles;
  for (std::size_t i = 0; i < nurbs.poles.size(); ++i)
    poles.insert(poles.end(), {nurbs.poles[i].x(), nurbs.poles[i].y(), nurbs.weights[i]});
  writeArray<double>(container, folder + "/poles", poles, 3);
  writeArray<double>(container, folder + "/knots", nurbs.knots);
  return {{"chord", revolved.chord()}, {"degree", static_cast<unsigned>(nurbs.degree)}, {"poles", nurbs.poles.size()}};
}

Result<GeometryPointer> readRevolved(const json& described, const std::string& folder, const Container& container,
                                     std::vector<Error>&) {
  const std::uint64_t count = countAt(described, "poles"), degree = countAt(described, "degree");
  const Error damaged{ArchiveError::EntryDamaged, {folder}, {}, {}};
  if (count > ProfileCurve::kMostPoles || degree > static_cast<std::uint64_t>(kHighestDegree)) return damaged;
  const auto poles = readArray<double>(container, folder + "/poles", count, 3);
  const auto knots = readArray<double>(container, folder + "/knots", count + degree + 1);
  if (!poles.lost.empty() || !knots.lost.empty() || poles.values.size() != 3 * count) return damaged;
  ProfileNurbs nurbs;
  nurbs.degree = static_cast<int>(degree);
  nurbs.knots = knots.values;
  for (std::size_t i = 0; i < poles.values.size(); i += 3) {
    nurbs.poles.emplace_back(poles.values[i], poles.values[i + 1]);
    nurbs.weights.push_back(poles.values[i + 2]);
  }
  Result<ProfileCurve> profile = ProfileCurve::make(std::move(nurbs));
  if (!profile) return profile.error();
  const auto chord = described.find("chord");
  const bool isGiven = chord != described.end() && chord->is_number();
  auto made = RevolvedGeometry::make(std::move(profile).value(), isGiven ? chord->get<double>() : 0.0);
  if (!made) return made.error();
  return GeometryPointer(std::move(made).value());
}

json writePrimitive(const BodyGeometry& geometry, const std::string&, Container&) {
  const auto& primitive = dynamic_cast<const PrimitiveGeometry&>(geometry);
  return {{"shape", primitive.description().id}, {"dimensions", primitive.dimensions()}};
}

Result<GeometryPointer> readPrimitive(const json& described, const std::string& folder, const Container&,
                                      std::vector<Error>&) {
  constexpr std::size_t kMostDimensions = 16;
  const std::string shape = stringAt(described, "shape");
  for (const PrimitiveDescription& each : primitives()) {
    if (each.id != shape) continue;
    auto made = PrimitiveGeometry::make(each.primitive, numbersAt(described, "dimensions", kMostDimensions));
    if (!made) return made.error();
    return GeometryPointer(std::move(made).value());
  }
  return Error{ErrorCode::Unsupported, {"the shape '" + shape + "' (" + folder + ")"}, {}, {}};
}

constexpr GeometryFormat kGeometryFormats[] = {
    {MeshGeometry::kKind, writeMesh, readMesh},
    {RevolvedGeometry::kKind, writeRevolved, readRevolved},
    {PrimitiveGeometry::kKind, writePrimitive, readPrimitive},
};

const GeometryFormat* formatOf(std::string_view kind, std::span<const GeometryFormat> own) {
  for (const std::span<const GeometryFormat> formats : {own, std::span<const GeometryFormat>(kGeometryFormats)}) {
    for (const GeometryFormat& format : formats) {
      if (format.kind == kind) return &format;
    }
  }
  return nullptr;
}

json writeUnknown(const UnknownGeometry& geometry, const std::string& folder, Container& container) {
  for (const auto& [name, bytes] : geometry.parts())
    container.blobs[std::string(folder).append("/").append(name)] = bytes;
  const Result<json> described = parseJson(geometry.description(), "geometry");
  return described ? *described : json();
}

}  // namespace

GeometryPointer keptAsItIs(const json& described, const std::string& folder, const Container& container,
                           bool isDamaged) {
  std::map<std::string, std::string> parts;
  const std::string start = folder + '/';
  for (auto blob = container.blobs.lower_bound(start); blob != container.blobs.end() && blob->first.starts_with(start);
       ++blob) {
    parts[blob->first.substr(start.size())] = blob->second;
  }
  return std::make_shared<const UnknownGeometry>(stringAt(described, "kind"),
                                                 described.dump(-1, ' ', false, json::error_handler_t::replace),
                                                 std::move(parts), isDamaged);
}

nlohmann::json writeGeometry(const BodyGeometry& geometry, const std::string& folder, Container& container,
                             std::span<const GeometryFormat> own) {
  if (const auto* unknown = dynamic_cast<const UnknownGeometry*>(&geometry))
    return writeUnknown(*unknown, folder, container);
  const GeometryFormat* format = formatOf(geometry.kind(), own);
  json described = format ? format->write(geometry, folder, container)
                          : writeSoupBlobs<double>(*geometry.surface(), folder, container);
  described["kind"] = format ? geometry.kind() : MeshGeometry::kKind;
  return described;
}

GeometryPointer readGeometry(const nlohmann::json& described, const std::string& folder, const Container& container,
                             std::vector<Error>& damage, std::span<const GeometryFormat> own) {
  const std::string kind = stringAt(described, "kind");
  if (kind.empty()) damage.push_back({ErrorCode::ElementMalformed, {folder, "its geometry has no type"}, {}, {}});
  const GeometryFormat* format = formatOf(kind, own);
  if (!format) return keptAsItIs(described, folder, container, kind.empty());
  Result<GeometryPointer> read = format->read(described, folder, container, damage);
  if (read) return std::move(read).value();
  damage.push_back(read.error());
  return keptAsItIs(described, folder, container, true);
}

}  // namespace handwheel
