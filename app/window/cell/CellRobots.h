// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/cell/RobotCellSnapshot.h"
#include "panels/MessageBar.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <functional>

class QComboBox;

namespace handwheel {

class RobotCellDocument;

// The robots of the current cell. The object adds a robot beside the other objects, removes one, and lets the user
// choose the robot that is planned for. The functions must be called on the window thread.
class CellRobots : public QObject {
  Q_OBJECT

 public:
  // selected: returns the name of the robot that is selected in the list, or an empty text.
  CellRobots(const WindowContext& parts, std::function<std::string()> selected, QObject* parent);

  void setDocument(DocumentTab* document);
  QList<QAction*> all() { return {&m_add, &m_addBuiltIn, &m_remove}; }
  QComboBox* box() const { return m_box; }  // owned by the window; hidden for a cell with one robot

  // Choose or remove a robot by its name. They do nothing if the cell has no such robot.
  void choose(const std::string& name);
  void remove(const std::string& name);

 signals:
  void message(const handwheel::Message& message);
  void added();  // Emitted when a robot was added to the cell in view

 private:
  using Reading = std::function<Result<OpenedFile>(Progress)>;

  RobotCellDocument& cell() const;
  void askForFile();
  void askForBuiltIn();
  void add(const QString& what, Reading reading);
  void addTo(DocumentTab& tab, const std::shared_ptr<const RobotCellSnapshot>& robot);
  void report(const Document& document, const Error& error);
  void update();

  WindowContext m_parts;
  std::function<std::string()> m_selected;
  DocumentTab* m_document = nullptr;
  QAction m_add, m_addBuiltIn, m_remove;
  QComboBox* m_box;
};

// Lets the user choose a robot of the library; chosen receives its id.
void askForLibraryRobot(QWidget* window, const QString& title, QObject* receiver,
                        const std::function<void(const char* id)>& chosen);

}  // namespace handwheel
