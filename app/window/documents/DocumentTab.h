// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "viewport/camera/CameraState.h"

#include <QString>

#include <memory>
#include <optional>

namespace handwheel {

class KindUi;

// An open document with its window state. Document kinds may derive their own types from it.
struct DocumentTab {
  DocumentTab(std::unique_ptr<Document> made, KindUi& of) : owned(std::move(made)), document(*owned), ui(of) {}
  virtual ~DocumentTab() = default;

  const std::unique_ptr<Document> owned;
  Document& document;
  KindUi& ui;                         // interface of the document's kind
  std::optional<CameraState> camera;  // none: the document has not been shown yet
  QString tool;                       // id of the active tool; empty: the default tool
  bool visible = true;
  bool written = false;  // the file was written by this program, so it contains nothing but the document
  bool cardDismissed = false;
  QString reportedLosses;       // the losses in reading the file that were last reported to the user
  std::uint64_t autosaved = 0;  // revision of the document that the autosave contains
  // The properties in the file, or those of a new document when it was created. None after a recovery, because they are
  // unknown.
  std::optional<std::vector<Property>> inFile;
};

}  // namespace handwheel
