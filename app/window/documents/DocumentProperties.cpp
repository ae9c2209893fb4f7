// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/DocumentProperties.h"

#include "document/Document.h"
#include "text/ErrorText.h"

namespace handwheel {

void connectEdits(PropertyList& list, std::function<Document*()> present, QObject* owner) {
  QObject::connect(&list, &PropertyList::edited, owner,
                   [present, &list](const std::string& id, const PropertyValue& value, bool stillDragging) {
                     if (Document* const document = present()) applyEdit(list, *document, id, value, stillDragging);
                   });
}

void applyEdit(PropertyList& list, Document& document, const std::string& id, const PropertyValue& value,
               bool stillDragging) {
  const Status done = document.setProperty(id, value, stillDragging ? DragPhase::Continues : DragPhase::Ends);
  if (done) return;
  emit document.changed();  // the fields show what it has
  list.refuse(id, value, errorSentence(done.error()));
}

DocumentProperties::DocumentProperties(PropertyList& list, QObject* parent) : QObject(parent), m_list(list) {
  connectEdits(
      m_list, [this] { return m_document; }, this);
}

void DocumentProperties::setDocument(Document* document, Listed listed) {
  if (m_document) m_document->disconnect(this);
  if (document != m_document) m_list.setProperties({});  // a text that was refused must not be shown for another one
  m_document = document;
  m_listed = std::move(listed);
  if (document) connect(document, &Document::changed, this, &DocumentProperties::show);
  show();
}

void DocumentProperties::show() {
  if (m_document) m_list.setLengthUnit(m_document->displayUnit());
  m_list.setProperties(m_document ? m_listed(*m_document) : std::vector<Property>());
}

}  // namespace handwheel
