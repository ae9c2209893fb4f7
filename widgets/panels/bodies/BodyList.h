// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/bodies/BodyModel.h"

#include <QTreeView>
#include <set>

namespace handwheel {

// A list of the bodies of a document: colour, name, link and eye. Several can be selected. F2 or a double click
// renames, Del removes, Space and a click on an eye hide or show; bodies are dragged onto their carriers. The list
// itself does not change the document, but emits requests.
class BodyList : public QTreeView {
  Q_OBJECT

 public:
  explicit BodyList(QWidget* parent = nullptr);

  void setBodies(const BodySet& bodies, const QStringList& carriers = {});  // see BodyModel
  // Selects these rows, and scrolls to a single one.
  void setSelected(const std::set<BodyId>& bodies);

 signals:
  void selected(const std::set<handwheel::BodyId>& bodies);  // emitted when the user changes the selection
  void renameRequested(handwheel::BodyId body, const QString& name);
  void removalRequested();  // the user wants to remove the selected bodies
  void visibilityRequested(const std::set<handwheel::BodyId>& bodies, bool visible);
  void carrierRequested(const std::set<handwheel::BodyId>& bodies, const QString& carrier);  // see BodyModel

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void startDrag(Qt::DropActions actions) override;

 private:
  std::set<BodyId> selectedBodies() const;
  bool clickEye(const QMouseEvent& event);
  void toggle(const BodyPointer& body);
  void follow();

  BodyModel* m_model;
  std::set<BodyId> m_selected;
  bool m_isFollowing = false;  // the selection is being set by the program, or rows are being inserted or removed
};

}  // namespace handwheel
