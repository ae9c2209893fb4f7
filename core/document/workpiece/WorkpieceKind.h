// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"

namespace handwheel {

// Document kind of workpieces for turning on a lathe.
class WorkpieceKind : public DocumentKind {
 public:
  std::string id() const override { return "workpiece"; }
  std::string title() const override;
  std::vector<FileFormat> formats() const override;
  // Recognises drawings only. The surfaces of STEP files are read as a mesh instead.
  bool recognises(std::string_view head, std::string_view name) const override;
  Result<OpenedFile> import(const std::filesystem::path& path, const ReadOptions& options,
                            Progress progress) const override;
  // Writes a workpiece to a file. A STEP file contains the exact surface as a solid, and is read back and measured
  // before it is kept. Mesh files contain triangles within the chord tolerance.
  Result<WrittenFile> exportTo(const Snapshot& content, const std::filesystem::path& path,
                               Progress progress) const override;
  void save(const Snapshot& content, Container& container) const override;
  Result<SnapshotPointer> load(const Container& container, std::vector<Error>& damage,
                               Progress progress) const override;
  SnapshotPointer blank() const override;
  std::unique_ptr<Document> make(OpenedFile opened) const override;
  nlohmann::json describe(const Snapshot& content) const override;
  DisplayModel display(const Snapshot& content) const override;
  // Returns the profile at the position of the bar, or triangles for a part in several pieces, with closed hollows or
  // with threads.
  GeometryPointer bodyGeometry(const Snapshot& content, std::vector<Note>& notes) const override;
};

}  // namespace handwheel
