// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ViewportTypes.h"

#include <QAction>
#include <QActionGroup>
#include <vector>

class QMenu;

namespace handwheel {

class Viewport;

// The actions of the View menu: standard views, shading and theme.
class ViewActions : public QObject {
  Q_OBJECT

 public:
  ViewActions(Viewport& viewport, QObject* parent = nullptr);

  QAction* fit() { return &m_fit; }
  QAction* darkTheme() { return &m_dark; }
  QList<QAction*> views() const;
  QList<QAction*> shadings() const { return m_shadings.actions(); }

 private:
  void addView(StandardView view, const QString& text, int key, const char* iconName, const char* name);
  void addShading(Shading shading, const QString& text, const char* iconName, const char* name);
  void useTheme(bool dark);

  Viewport& m_viewport;
  QAction m_fit;
  QAction m_dark;
  std::vector<QAction*> m_views;
  QActionGroup m_shadings;
};

}  // namespace handwheel
