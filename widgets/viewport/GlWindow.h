// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <QSize>

class QOpenGLWidget;
class vtkRenderer;

namespace handwheel {

// Lets VTK draw inside a QOpenGLWidget. VTK renders to framebuffers of its own, which are then copied to the widget's.
// All calls need the widget's context current, but for the constructor.
class GlWindow {
 public:
  explicit GlWindow(vtkRenderer* renderer);
  ~GlWindow();

  // For each new context of the widget; it gets another when it moves to another window.
  void attach(QOpenGLWidget* widget);
  // Frees what belongs to the context, before that goes.
  void detach();
  bool isAttached() const { return m_widget != nullptr; }
  // size in device pixels.
  void draw(const QSize& size);
  // What was drawn last once more: at the cost of a copy.
  void drawAgain();

 private:
  void makeContextCurrent();
  void copy();
  void reportIsCurrent(vtkObject* caller, unsigned long event, void* isCurrent);

  vtkNew<vtkGenericOpenGLRenderWindow> m_window;
  QOpenGLWidget* m_widget = nullptr;
};

}  // namespace handwheel
