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

// The open documents with their state, each with a small picture. Who goes through the rows with the arrow keys sees
// each; a click or Return goes on to its view. The eye, or Space, shows or hides the surface.
class DocumentsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DocumentsPanel(QWidget* parent = nullptr);

  void addDocument(Document* document);
  void removeDocument(Document* document);
  void setCurrent(Document* document);
  // Instead of the icon of its kind; a null one changes nothing.
  void setPicture(const Document* document, const QPixmap& picture);

  // Hides the surface of the present document, or shows it again.
  QAction* visibilityAction() { return &m_visibility; }

 signals:
  void chosen(handwheel::Document* document);     // among the rows, where the keys stay
  void activated(handwheel::Document* document);  // to work on it
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
