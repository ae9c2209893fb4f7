// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/MessageBar.h"
#include "tools/scene/BodyOperation.h"
#include "tools/scene/BodySelection.h"
#include "window/kinds/KindUi.h"

#include <QMenu>

namespace handwheel {

struct RobotCellSnapshot;

class BodyList;
class RobotCellDocument;
struct CellRobot;
struct PrimitiveDescription;

// The list of the bodies of a robot cell, their actions, and their selection.
class CellBodies : public QObject {
  Q_OBJECT

 public:
  CellBodies(const WindowContext& parts, QObject* parent);

  void setDocument(DocumentTab* document);  // Null: no cell is in view
  BodyPointer selected() const;             // Null unless exactly one body is selected
  BodySelection& selection() { return m_selection; }
  const BodySelection& selection() const { return m_selection; }
  QList<QAction*> all();
  // Moves a body in front of all other objects, onto the floor. Does nothing if a link carries the body.
  void placeBeside(BodyId id);
  QList<QAction*> adding();            // Actions that add a body
  QMenu& menu() { return *m_menu; }    // Menu of all actions
  BodyList* list() { return m_list; }  // Owned by the window

 signals:
  void selectionChanged();
  void chosen(handwheel::BodyId body);  // The body was chosen in the list and should be shown
  void added(handwheel::BodyId body, bool isFromFile);
  void message(const handwheel::Message& message);

 private:
  RobotCellDocument& cell() const;
  void connectActions();
  void connectList();
  void addShapes();
  void addShape(const PrimitiveDescription& primitive);
  const Box& robotAtRest(const RobotCellSnapshot& content);
  bool standBeside(const RobotCellSnapshot& content, Body& body, OperationValues& values);
  void placeAsInFile(BodyId id);
  void place(BodyId id, const Pose& pose, const QString& text);  // text: undo text, with %1 for the name of the body
  void askForFile(const QString& title, const std::function<void(const std::string& path)>& chosen);
  void setVisible(const std::set<BodyId>& ids, bool visible);
  void removeSelected();
  void mountSelected();
  void setCentreAtTip(BodyId id);  // Sets the tool centre point to the tip of the body
  void carry(const std::set<BodyId>& ids, std::uint32_t link);
  void rename(BodyId body, const QString& name);
  void applyToSelected(const char* verb);
  void relinkSelected();
  void askForUnit();
  void scale(BodyId id, double factor);
  void reportAdded(BodyId id, const QString& file, bool hasUnit, bool isBeside);
  void apply(const OperationValues& values);
  void read(const OperationValues& values);
  void commit(DocumentTab& tab, const OperationValues& values, Result<BodyChange> change, bool isBeside = false);
  bool isOnFlange(const Body& body) const;
  void report(const Document& document, const Error& error);
  void update();

  WindowContext m_parts;
  DocumentTab* m_document = nullptr;
  BodySelection m_selection;
  BodyList* m_list;
  QMenu* m_shapes;  // Owned by the window
  QAction m_add, m_link, m_rename, m_unit, m_beside, m_mount, m_tip, m_release, m_remove, m_hide, m_showAll, m_update,
      m_relink, m_unlink;
  QMenu* m_menu;  // Owned by the window
  std::weak_ptr<const CellRobot> m_measured;
  Box m_robotAtRest;  // Bounds of m_measured at rest
};

}  // namespace handwheel
