// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Tolerance.h"
#include "document/DocumentKind.h"
#include "document/mesh/MeshSnapshot.h"

#include <atomic>

namespace handwheel {

inline constexpr std::string_view kMeshKind = "mesh";

// Document kind of triangle meshes, such as scans.
class MeshKind : public DocumentKind {
 public:
  // Sets mesh.near_weld for the defects of files that are opened from now on. May be called on any thread.
  void setNearWeld(double share) { m_nearWeld = share; }
  // Sets step.chord for STEP files that are opened from now on. May be called on any thread.
  void setStepChord(double share) { m_stepChord = share; }

  std::string id() const override { return std::string(kMeshKind); }
  std::string title() const override;
  std::vector<FileFormat> formats() const override;
  // Returns true for all files that no other kind recognises, because the readers of this kind give the best error
  // messages.
  bool recognises(std::string_view head, std::string_view name) const override;
  Result<OpenedFile> import(const std::filesystem::path& path, const ReadOptions& options,
                            Progress progress) const override;
  Result<WrittenFile> exportTo(const Snapshot& content, const std::filesystem::path& path,
                               Progress progress) const override;
  void save(const Snapshot& content, Container& container) const override;
  Result<SnapshotPointer> load(const Container& container, std::vector<Error>& damage,
                               Progress progress) const override;
  bool isMadeOfSurfaces() const override { return true; }
  Result<SnapshotPointer> ofSurface(const TriangleSoup& surface, const std::string& source,
                                    Progress progress) const override;
  std::unique_ptr<Document> make(OpenedFile opened) const override;
  nlohmann::json describe(const Snapshot& content) const override;
  DisplayModel display(const Snapshot& content) const override;

 private:
  std::atomic<double> m_nearWeld = tolerance::kNearWeld;  // fraction of the diagonal
  std::atomic<double> m_stepChord = ReadOptions().stepChord;
};

// Creates the snapshot of a mesh document from a mesh file. nearWeld: as in findDefects(). The result is invalid if
// cancelled.
std::shared_ptr<MeshSnapshot> meshSnapshotOf(const MeshFile& file, double nearWeld = tolerance::kNearWeld,
                                             Progress progress = {});

}  // namespace handwheel
