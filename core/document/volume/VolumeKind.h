// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "volume/surface/VolumeSurface.h"

#include <atomic>

namespace handwheel {

// The document kind of voxel volumes. It exports their surface in the formats of meshes.
class VolumeKind : public DocumentKind {
 public:
  // Sets the number of cells per piece (see VolumeSurface) for volumes that are opened or made later. May be called on
  // any thread.
  void setPieceCells(int cells) { m_pieceCells = cells; }
  int pieceCells() const { return m_pieceCells; }

  std::string id() const override { return "volume"; }
  std::string title() const override;
  std::vector<FileFormat> formats() const override;
  bool recognises(std::string_view head, std::string_view name) const override;
  bool readsFolders() const override { return true; }
  bool hasPrivateName(const std::filesystem::path& path) const override;
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
  // Returns the content of a new document: a ball of clay.
  SnapshotPointer blank() const override;
  std::unique_ptr<Document> make(OpenedFile opened) const override;
  nlohmann::json describe(const Snapshot& content) const override;
  DisplayModel display(const Snapshot& content) const override;

 private:
  std::atomic<int> m_pieceCells = VolumeSurface::kPieceCells;
};

}  // namespace handwheel
