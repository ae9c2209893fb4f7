// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/property/PropertyList.h"

#include <functional>

namespace handwheel {

class Document;

// Applies edits in a property list to the document that present() returns. A drag is one undo step. If the document
// refuses an edit, the list shows the reason.
void connectEdits(PropertyList& list, std::function<Document*()> present, QObject* owner);
// Applies a single edit.
void applyEdit(PropertyList& list, Document& document, const std::string& id, const PropertyValue& value,
               bool stillDragging);

// Shows the properties of a document in a list and keeps them up to date.
class DocumentProperties : public QObject {
  Q_OBJECT

 public:
  explicit DocumentProperties(PropertyList& list, QObject* parent = nullptr);

  using Listed = std::function<std::vector<Property>(const Document&)>;
  // Sets the document; null: none. listed: the function that returns the properties to show.
  void setDocument(Document* document, Listed listed);
  // Updates the list. To be called when other properties are to be listed.
  void show();

 private:
  PropertyList& m_list;
  Listed m_listed;
  Document* m_document = nullptr;
};

}  // namespace handwheel
