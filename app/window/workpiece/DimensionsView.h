// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/path/PathLayer.h"
#include "window/JobRunner.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <memory>

namespace handwheel {

// Shows the dimensions of a turned part in the view. They are the dimensions of its drawing, shown in the plane that
// faces the operator of the lathe. It must be used on the window thread.
class DimensionsView : public QObject {
  Q_OBJECT

 public:
  DimensionsView(const WindowContext& parts, QObject* parent);
  ~DimensionsView() override;

  QAction* action() { return &m_toggle; }
  void setDocument(DocumentTab* document);
  void setVisible(bool isVisible);  // visibility of the document
  bool isSettled() const { return m_measuring.isIdle(); }

 private:
  void refresh();

  WindowContext m_parts;
  QAction m_toggle;
  std::shared_ptr<PathLayer> m_layer;
  DocumentTab* m_document = nullptr;
  bool m_isVisible = true;
  bool m_isFromBehind = false;  // the texts are for a camera behind the part
  JobRunner m_measuring;
};

}  // namespace handwheel
