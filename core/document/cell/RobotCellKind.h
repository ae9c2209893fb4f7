// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "robot/ShapeSurfaces.h"

#include <atomic>

namespace handwheel {

struct RobotCellSnapshot;

// Document kind of robot cells. A cell consists of a URDF description, meshes, joint values and bodies.
class RobotCellKind : public DocumentKind {
 public:
  // Sets cell.shape_sides for the robots that are opened from now on. The function may be called on any thread.
  void setShapeSides(std::uint32_t sides) { m_shapeSides = sides; }

  std::string id() const override { return "cell"; }
  std::string title() const override;
  std::vector<FileFormat> formats() const override;
  bool recognises(std::string_view head, std::string_view name) const override;
  // Imports a robot from a URDF file or a table of Denavit-Hartenberg parameters. Missing or damaged meshes do not
  // prevent the import; they are omitted.
  Result<OpenedFile> import(const std::filesystem::path& path, const ReadOptions& options,
                            Progress progress) const override;
  // Exports the displayed surfaces as one mesh.
  Result<WrittenFile> exportTo(const Snapshot& content, const std::filesystem::path& path,
                               Progress progress) const override;
  void save(const Snapshot& content, Container& container) const override;
  Result<SnapshotPointer> load(const Container& container, std::vector<Error>& damage,
                               Progress progress) const override;
  SnapshotPointer withCheckedLinks(SnapshotPointer content, const std::filesystem::path& folder,
                                   std::vector<Note>& notes, Progress progress) const override;
  std::vector<std::filesystem::path> linkedFiles(const Snapshot& content) const override;
  std::unique_ptr<Document> make(OpenedFile opened) const override;
  nlohmann::json describe(const Snapshot& content) const override;
  GeometryPointer bodyGeometry(const Snapshot& content, std::vector<Note>& notes) const override;
  DisplayModel display(const Snapshot& content) const override;

 private:
  std::atomic<std::uint32_t> m_shapeSides = kShapeSides;
};

// Returns the value of the key "robots" of describe(): an array with the name, title, position and other data of each
// robot, and whether it is the planned one.
nlohmann::json describeRobots(const RobotCellSnapshot& cell);

}  // namespace handwheel
