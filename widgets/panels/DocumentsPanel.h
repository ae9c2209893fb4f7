// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QTreeWidget;
class QTreeWidgetItem;

namespace handwheel {

class Document;

// The open documents with their state. A click makes one the present document; its eye shows or hides the surface.
class DocumentsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DocumentsPanel(QWidget* parent = nullptr);

  void addDocument(Document* document);
  void removeDocument(Document* document);
  void setCurrent(Document* document);

 signals:
  void activated(handwheel::Document* document);
  void visibilityChanged(handwheel::Document* document, bool visible);

 private:
  QTreeWidgetItem* itemOf(const Document* document) const;
  void refresh(const Document* document);

  QTreeWidget* m_tree;
};

}  // namespace handwheel
