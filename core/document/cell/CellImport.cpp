// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellImport.h"

#include "base/NumberText.h"
#include "document/FileBytes.h"
#include "document/cell/ColladaReader.h"
#include "document/cell/SurfaceBudget.h"
#include "document/cell/proof/RestingPairs.h"
#include "document/formats/MeshFormat.h"
#include "mesh/structure/Weld.h"
#include "robot/MeshLocation.h"
#include "robot/UrdfReader.h"
#include "robot/UrdfValues.h"
#include "robot/UrdfWriter.h"

#include <QFile>
#include <QtGlobal>
#include <algorithm>
#include <optional>

namespace handwheel {

namespace {

constexpr std::uintmax_t kLargestMesh = std::uintmax_t{256} << 20;  // bytes
constexpr std::uintmax_t kLargestDescription = std::uintmax_t{16} << 20;

Result<std::string> readBounded(const std::filesystem::path& path, std::uintmax_t limit, Progress progress) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (!failed && size > limit)
    return Error{ErrorCode::FileTooLarge, {"bytes", std::to_string(size), std::to_string(limit)}, {}, {}};
  return readFileBytes(path, progress);
}

// In metres.
Result<TriangleSoup> readMetres(const std::filesystem::path& path, std::vector<Error>& damage, Progress progress) {
  const Result<std::string> bytes = readBounded(path, kLargestMesh, progress.part(0.0, 0.3));
  if (!bytes) return bytes.error();
  if (looksLikeCollada(std::string_view(*bytes).substr(0, 4096))) {
    Result<ColladaMesh> mesh = readCollada(*bytes, progress.part(0.3, 1.0));
    if (!mesh) return mesh.error();
    damage = std::move(mesh->damage);
    return std::move(mesh->soup);
  }
  Result<MeshFile> mesh = readMesh(*bytes, path.filename().string(), {.partial = true}, progress.part(0.3, 1.0));
  if (!mesh) return mesh.error();
  damage = std::move(mesh->damage);
  return std::move(mesh->soup);
}

Error withPath(Error error, const std::filesystem::path& path) {
  if (error.subject.empty()) error.subject = path.string();
  return error;
}

Result<TriangleSoup> readMeshSurface(const MeshShape& shape, const std::filesystem::path& path,
                                     std::vector<Error>& damage, Progress progress) {
  Result<TriangleSoup> soup = readMetres(path, damage, progress);
  if (!soup) return soup.error();
  place(shape, *soup);
  for (const Triangle& t : soup->triangles) {
    for (std::uint32_t corner : t) {
      const Vec3& p = soup->points[corner];
      if (p.allFinite() && p.cwiseAbs().maxCoeff() <= kLargestCoordinate) continue;
      const std::string largest = QString::number(p.cwiseAbs().maxCoeff()).toStdString();
      return Error{ErrorCode::ValueOutOfRange, {"a coordinate of the mesh", largest, "-1e9", "1e9"}, {}, {}};
    }
  }
  roundPoints(*soup, NumberType::Float32);
  return weld(*soup);
}

class Import {
 public:
  Import(ImportedRobot read, std::filesystem::path folder, std::uint32_t shapeSides)
      : m_folder(std::move(folder)), m_shapeSides(shapeSides), m_robot(new CellRobot) {
    m_robot->model = std::move(read.robot);
    m_robot->arms = {wholeArm(m_robot->model)};
    m_result.damage = std::move(read.damage);
    m_result.unlistedDamage = read.unlistedDamage;
  }

  // False when somebody cancelled.
  bool readSurfaces(Progress progress) {
    const auto& shapes = m_robot->model.shapes;
    SurfaceBudget budget(m_robot->model);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const auto part = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(shapes.size()); };
      auto surface = surfaceOfShape(shapes[i], progress.part(part(i), part(i + 1)));
      if (surface && !budget.take(i, *surface)) {
        note(SurfaceBudget::exceeded());
        surface = nullptr;
      }
      m_robot->surfaces.push_back(std::move(surface));
      if (progress.cancelled()) return false;
    }
    return true;
  }

  ImportedCell finish(std::string description, std::string source) {
    m_robot->description = std::move(description);
    auto cell = std::make_shared<RobotCellSnapshot>();
    cell->joints = restValues(m_robot->model);
    cell->robot = std::move(m_robot);
    cell->source = std::move(source);
    m_result.cell = std::move(cell);
    return std::move(m_result);
  }

 private:
  std::shared_ptr<const TriangleSoup> surfaceOfShape(const Shape& shape, Progress progress) {
    if (!std::holds_alternative<MeshShape>(shape)) return roundedSurface(shape, m_shapeSides);
    std::vector<Error> damage;
    Result<TriangleSoup> soup = readSurface(shape, m_folder, damage, progress);
    if (!soup) damage = {soup.error()};
    for (Error& error : damage) note(std::move(error));
    return soup ? std::make_shared<const TriangleSoup>(std::move(soup).value()) : nullptr;
  }

  // A package that is missing is reported once, not for each of its meshes.
  void note(Error error) {
    constexpr std::size_t kMostNotes = 1000;
    const auto isSame = [&](const Error& reported) {
      return reported.code == error.code && reported.arguments == error.arguments && reported.subject == error.subject;
    };
    if (error.code == ErrorCode::ReferenceMissing &&
        std::any_of(m_result.damage.begin(), m_result.damage.end(), isSame))
      return;
    if (m_result.damage.size() < kMostNotes)
      m_result.damage.push_back(std::move(error));
    else
      ++m_result.unlistedDamage;
  }

  std::filesystem::path m_folder;
  std::uint32_t m_shapeSides;
  std::shared_ptr<CellRobot> m_robot;
  ImportedCell m_result;
};

// Adds a note on links of an unlikely size, and on joints that are unlikely far from their links: numbers in mm where a
// description has metres.
void noteSizes(const CellRobot& robot, std::vector<Note>& notes) {
  constexpr double kUnlikely = 20e3;  // mm; no link of an arm is as long, and in mm a part of 20 mm would be
  const auto text = [](double size) { return roundedText(size / kMillimetresPerMetre, 3); };
  for (const Link& link : robot.model.links) {
    double size = 0.0;
    for (const auto* const shapes : {&link.visuals, &link.collisions}) {
      for (const PlacedShape& placed : *shapes) {
        Box box;
        if (!robot.surfaces[placed.shape]) continue;
        for (const Vec3& point : robot.surfaces[placed.shape]->points) box.extend(point);
        if (!box.isEmpty()) size = std::max(size, box.sizes().maxCoeff());
      }
    }
    if (size < kUnlikely) continue;
    notes.push_back({QT_TRANSLATE_NOOP("Note",
                                       "The link %1 is %2 m large. Descriptions are in metres: if the mesh is in mm, "
                                       "give it scale=\"0.001 0.001 0.001\"."),
                     {link.name, text(size)}});
  }
  for (const Joint& joint : robot.model.joints) {
    const double far = joint.origin.translation().norm();
    if (far < kUnlikely) continue;
    notes.push_back({QT_TRANSLATE_NOOP("Note",
                                       "The joint %1 is %2 m from the link before it. Descriptions are in metres: "
                                       "check its origin."),
                     {joint.name, text(far)}});
  }
}

// The cell with the overlaps of plain shapes as pairs that may touch.
std::shared_ptr<const RobotCellSnapshot> withOverlaps(const RobotCellSnapshot& cell, const DhTable& table) {
  CellPlans plans = *cell.plans;
  const auto& links = cell.robot->model.links;
  for (const auto& [a, b] : overlappingLinks(table)) plans.allowed.insert({links[a].name, links[b].name});
  auto changed = std::make_shared<RobotCellSnapshot>(cell);
  changed->plans = std::make_shared<const CellPlans>(std::move(plans));
  return changed;
}

}  // namespace

std::shared_ptr<const RobotCellSnapshot> cellOf(const DhTable& robot, std::uint32_t shapeSides) {
  ImportedRobot read;
  read.robot = robotOf(robot);
  std::string description = urdfOf(read.robot);
  Import import(std::move(read), {}, shapeSides);
  import.readSurfaces({});
  std::vector<Note> known;
  return withRestingPairs(withOverlaps(*import.finish(std::move(description), {}).cell, robot), known);
}

std::shared_ptr<const TriangleSoup> roundedSurface(const Shape& shape, std::uint32_t sides) {
  TriangleSoup soup = surfaceOf(shape, sides);
  roundPoints(soup, NumberType::Float32);
  return std::make_shared<const TriangleSoup>(std::move(soup));
}

Result<TriangleSoup> readSurface(const Shape& shape, const std::filesystem::path& folder, std::vector<Error>& damage,
                                 Progress progress) {
  const auto* mesh = std::get_if<MeshShape>(&shape);
  if (!mesh) return *roundedSurface(shape, kShapeSides);
  const Result<std::filesystem::path> path = locateMesh(mesh->file, folder);
  if (!path) return path.error();
  Result<TriangleSoup> soup = readMeshSurface(*mesh, *path, damage, progress);
  for (Error& error : damage) error = withPath(std::move(error), *path);
  if (!soup) return withPath(soup.error(), *path);
  return soup;
}

Result<ImportedCell> importCell(const std::filesystem::path& path, std::uint32_t shapeSides, Progress progress) {
  Result<std::string> bytes = readBounded(path, kLargestDescription, progress.part(0.0, 0.05));
  if (!bytes) return bytes.error();
  std::optional<DhTable> table;
  if (looksLikeDhTable(*bytes)) {
    Result<DhTable> given = readDhTable(*bytes);
    if (!given) return given.error();
    table = std::move(given).value();
    bytes = urdfOf(robotOf(*table));
  }
  Result<ImportedRobot> read = readUrdf(*bytes, progress.part(0.05, 0.1));
  if (!read) return read.error();
  Import import(std::move(read).value(), path.parent_path(), shapeSides);
  if (!import.readSurfaces(progress.part(0.1, 1.0))) return Error{ErrorCode::Cancelled, {}, {}, {}};
  const std::string source = QFile::decodeName(QByteArray::fromStdString(path.string())).toStdString();
  ImportedCell imported = import.finish(std::move(bytes).value(), source);
  if (table) imported.cell = withOverlaps(*imported.cell, *table);
  noteSizes(*imported.cell->robot, imported.notes);
  imported.cell = withRestingPairs(std::move(imported.cell), imported.notes);
  return imported;
}

}  // namespace handwheel
