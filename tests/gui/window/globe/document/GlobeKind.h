// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"

namespace handwheel::test {

// The error code of globes.
namespace GlobeError {

extern const ErrorDescription Flat;  // {file}

}  // namespace GlobeError

// The kind of globes. Its foreign format is text: a line "globe RADIUS", and a line "dent NUMBER FRACTION" for each
// point that is pushed in. The format contains no names or poses.
class GlobeKind : public DocumentKind {
 public:
  std::string id() const override { return "globe"; }
  std::string title() const override { return "Globe"; }
  std::vector<FileFormat> formats() const override { return {{"Globe", {".globe"}}}; }
  bool recognises(std::string_view head, std::string_view name) const override;
  Result<OpenedFile> import(const std::filesystem::path& path, const ReadOptions& options,
                            Progress progress) const override;
  Result<WrittenFile> exportTo(const Snapshot& content, const std::filesystem::path& path,
                               Progress progress) const override;
  void save(const Snapshot& content, Container& container) const override;
  Result<SnapshotPointer> load(const Container& container, std::vector<Error>& damage,
                               Progress progress) const override;
  SnapshotPointer blank() const override;
  std::unique_ptr<Document> make(OpenedFile opened) const override;
  nlohmann::json describe(const Snapshot& content) const override;
  DisplayModel display(const Snapshot& content) const override;
};

}  // namespace handwheel::test
