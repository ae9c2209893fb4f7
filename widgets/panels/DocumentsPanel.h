// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QTreeWidget;
class QTreeWidgetItem;

namespace handwheel {

class MeshDocument;

// The open documents with their state. A click makes one the present document; its eye shows or hides the surface.
class DocumentsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DocumentsPanel(QWidget* parent = nullptr);

  void addDocument(MeshDocument* document);
  void removeDocument(MeshDocument* document);
  void setCurrent(MeshDocument* document);

 signals:
  void activated(handwheel::MeshDocument* document);
  void visibilityChanged(handwheel::MeshDocument* document, bool visible);

 private:
  QTreeWidgetItem* itemOf(const MeshDocument* document) const;
  void refresh(const MeshDocument* document);

  QTreeWidget* m_tree;
};

}  // namespace handwheel
