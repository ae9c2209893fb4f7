// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QPixmap>
#include <QWidget>

class QTreeWidget;
class QTreeWidgetItem;

namespace handwheel {

class Document;

// A list of the open documents with state and thumbnail. The arrow keys show the document of each row; a click or
// Return also moves the focus to the view. The eye icon, or Space, shows or hides the surface.
class DocumentsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DocumentsPanel(QWidget* parent = nullptr);

  void addDocument(Document* document);
  void removeDocument(Document* document);
  void setCurrent(Document* document);
  // Shows a picture of a document instead of the icon of its kind. A null picture changes nothing.
  void setPicture(const Document* document, const QPixmap& picture);

  // Returns the action that hides or shows the surface of the current document.
  QAction* visibilityAction() { return &m_visibility; }

 signals:
  void chosen(handwheel::Document* document);     // emitted when a row is chosen by keyboard; the list keeps the focus
  void activated(handwheel::Document* document);  // emitted for a click or Return
  void visibilityChanged(handwheel::Document* document, bool visible);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QTreeWidgetItem* itemOf(const Document* document) const;
  void refresh(const Document* document);
  void toggle(QTreeWidgetItem* item);
  bool takesKey(int key);
  QTreeWidgetItem* itemWithEyeAt(const QPoint& position) const;

  QTreeWidget* m_tree;
  QAction m_visibility;
};

}  // namespace handwheel
