// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <QSize>

class QOpenGLWidget;
class vtkRenderer;

namespace handwheel {

// Lets VTK render into a QOpenGLWidget. VTK renders to its own framebuffers, which are then copied to that of the
// widget. The widget's context must be current in all calls except the constructor.
class GlWindow {
 public:
  explicit GlWindow(vtkRenderer* renderer);
  ~GlWindow();

  // Attaches to a widget. To be called for each new context of the widget, which gets another one when it moves to
  // another window.
  void attach(QOpenGLWidget* widget);
  // Frees the resources of the context; to be called before it is destroyed.
  void detach();
  bool isAttached() const { return m_widget != nullptr; }
  // Renders a frame. size: the size in device pixels.
  void draw(const QSize& size);
  // Shows the last frame again; costs only a copy.
  void drawAgain();

 private:
  void makeContextCurrent();
  void copy();
  void reportIsCurrent(vtkObject* caller, unsigned long event, void* isCurrent);

  vtkNew<vtkGenericOpenGLRenderWindow> m_window;
  QOpenGLWidget* m_widget = nullptr;
};

}  // namespace handwheel
