// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/PropertyList.h"

#include <functional>

namespace handwheel {

class Document;

// Applies edits in a property list to the document that present() returns. A drag is one undo step. When the document
// refuses an edit, the list shows the former value again.
void connectEdits(PropertyList& list, std::function<Document*()> present, QObject* owner);

// Shows all properties of a document in a list and keeps them up to date.
class DocumentProperties : public QObject {
  Q_OBJECT

 public:
  explicit DocumentProperties(PropertyList& list, QObject* parent = nullptr);

  // Null: none.
  void setDocument(Document* document);

 private:
  void show();

  PropertyList& m_list;
  Document* m_document = nullptr;
};

}  // namespace handwheel
