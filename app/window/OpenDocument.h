// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "viewport/CameraState.h"

#include <QString>

#include <memory>
#include <optional>

namespace handwheel {

class KindUi;

// A document with what the window remembers about it while it is open. Kinds derive their own.
struct OpenDocument {
  OpenDocument(std::unique_ptr<Document> made, KindUi& of) : owned(std::move(made)), document(*owned), ui(of) {}
  virtual ~OpenDocument() = default;

  const std::unique_ptr<Document> owned;
  Document& document;
  KindUi& ui;                         // of its kind
  std::optional<CameraState> camera;  // absent until it was shown
  QString tool;                       // the id of the one in use; empty: the usual one
  bool visible = true;
  bool written = false;  // its file was written by us, so it holds nothing that the document does not
  bool cardDismissed = false;
  QString toldLosses;           // what its file lacks, as its user was told last
  std::uint64_t autosaved = 0;  // the revision that an autosave holds
  // As they stand in its file, or in a blank document. Absent after a recovery, when nobody knows.
  std::optional<std::vector<Property>> inFile;
};

}  // namespace handwheel
