// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/MessageBar.h"
#include "tools/scene/BodyOperation.h"
#include "tools/scene/BodySelection.h"
#include "window/kinds/KindUi.h"

#include <QMenu>

namespace handwheel {

class RobotCellDocument;
struct PrimitiveDescription;

// The menu actions for the bodies of a robot cell, and which body is selected.
class CellBodies : public QObject {
  Q_OBJECT

 public:
  CellBodies(const WindowContext& parts, QObject* parent);

  void setDocument(DocumentTab* document);  // null: no cell is in view
  BodySelection& selection() { return m_selection; }
  const BodySelection& selection() const { return m_selection; }
  QList<QAction*> all();

 signals:
  void selectionChanged();
  void message(const handwheel::Message& message);

 private:
  RobotCellDocument& cell() const;
  BodyPointer selected() const;
  void addShapes();
  void addShape(const PrimitiveDescription& primitive);
  void askForFile(bool isLinked);
  void setVisible(const std::vector<BodyId>& ids, bool visible, const QString& text);
  void applyToSelected(const char* verb);
  void apply(const OperationValues& values);
  void applyAfterReading(const OperationValues& values);
  void commit(const OperationValues& values, BodyChange change);
  void report(const Error& error);
  void update();

  WindowContext m_parts;
  DocumentTab* m_document = nullptr;
  BodySelection m_selection;
  QMenu* m_shapes;  // owned by the window
  QAction m_add, m_link, m_remove, m_hide, m_showAll, m_update, m_unlink;
};

}  // namespace handwheel
