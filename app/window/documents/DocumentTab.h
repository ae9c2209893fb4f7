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

// An open document with its window state. Kinds of documents derive from it.
struct DocumentTab {
  DocumentTab(std::unique_ptr<Document> made, KindUi& of) : owned(std::move(made)), document(*owned), ui(of) {}
  virtual ~DocumentTab() = default;

  const std::unique_ptr<Document> owned;
  Document& document;
  KindUi& ui;                         // interface of the document's kind
  std::optional<CameraState> camera;  // absent until it is first shown
  QString tool;                       // id of the active tool; empty: the default tool
  bool visible = true;
  bool written = false;  // its file was written by this program, so it holds nothing else than the document
  bool cardDismissed = false;
  QString reportedLosses;       // the losses of its file, as last reported to the user
  std::uint64_t autosaved = 0;  // revision of the document in its autosave
  // The properties in its file, or of a new document. Absent after a recovery, as they are unknown then.
  std::optional<std::vector<Property>> inFile;
};

}  // namespace handwheel
