// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/PropertyList.h"

#include <functional>

namespace handwheel {

class Document;

// Edits in the list change the document that present() gives, a drag as one step. What the document refuses is shown
// back as it was.
void connectEdits(PropertyList& list, std::function<Document*()> present, QObject* owner);

// Shows all properties of a document in a list, and follows it. Null: none.
class DocumentProperties : public QObject {
  Q_OBJECT

 public:
  explicit DocumentProperties(PropertyList& list, QObject* parent = nullptr);

  void setDocument(Document* document);

 private:
  void show();

  PropertyList& m_list;
  Document* m_document = nullptr;
};

}  // namespace handwheel
