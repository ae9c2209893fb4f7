// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace handwheel {

struct MeshTab;

// The selected loop and the hovered loop of the current document. It is shared by the list and the viewport.
class LoopSelection : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  int loop() const { return m_loop; }        // -1: none
  int hovered() const { return m_hovered; }  // -1: none

  // Restores the selection that the document had when it was last shown. Null: no document is open.
  void setDocument(MeshTab* document);
  void select(int loop);
  void hover(int loop);

 signals:
  void changed();
  void hoverChanged();

 private:
  void follow();

  MeshTab* m_document = nullptr;
  int m_loop = -1;
  int m_hovered = -1;
};

}  // namespace handwheel
