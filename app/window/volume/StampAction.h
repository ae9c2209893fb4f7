// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/volume/ClayTool.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <QObject>

namespace handwheel {

// The command that loads a stamp for the clay tool from a file. Loaded stamps are available until the program ends.
class StampAction : public QObject {
  Q_OBJECT

 public:
  StampAction(const WindowContext& parts, QObject* parent);

  void setDocument(DocumentTab* document);
  QAction* action() { return &m_action; }
  ClayTool::StampServices services();

 signals:
  void message(const Message& message);

 private:
  void ask();
  void load(const QString& path);
  void use(std::size_t number);

  WindowContext m_parts;
  QAction m_action;
  DocumentTab* m_document = nullptr;
  std::shared_ptr<ClayStamps> m_stamps = std::make_shared<ClayStamps>();
};

}  // namespace handwheel
