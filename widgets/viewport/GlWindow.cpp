// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/GlWindow.h"

#include <vtkAutoInit.h>
#include <vtkCommand.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLWidget>

// VTK's module for CMake would pass the name of a file in the build folder to the compiler, with which no other
// checkout finds the objects in the compiler's cache.
VTK_MODULE_INIT(vtkRenderingOpenGL2)

namespace handwheel {

GlWindow::GlWindow(vtkRenderer* renderer) {
  m_window->SetFrameBlitModeToNoBlit();
  m_window->SetReadyForRendering(false);
  m_window->SetMultiSamples(0);
  m_window->AddRenderer(renderer);
  m_window->AddObserver(vtkCommand::WindowMakeCurrentEvent, this, &GlWindow::makeContextCurrent);
  // Without an answer, Render() silently does nothing.
  m_window->AddObserver(vtkCommand::WindowIsCurrentEvent, this, &GlWindow::reportIsCurrent);
}

GlWindow::~GlWindow() {
  m_window->RemoveAllObservers();
}

// Does nothing if it is current already: the widget would also bind Qt's framebuffer, and VTK asks while it builds its
// own.
void GlWindow::makeContextCurrent() {
  if (m_widget && QOpenGLContext::currentContext() != m_widget->context()) m_widget->makeCurrent();
}

void GlWindow::reportIsCurrent(vtkObject*, unsigned long, void* isCurrent) {
  *static_cast<bool*>(isCurrent) = m_widget && QOpenGLContext::currentContext() == m_widget->context();
}

void GlWindow::attach(QOpenGLWidget* widget) {
  m_widget = widget;
  vtkOpenGLState* state = m_window->GetState();
  state->Reset();
  // VTK expects LEQUAL as the rest state, Qt leaves LESS.
  state->vtkglDepthFunc(GL_LEQUAL);
  m_window->SetOwnContext(0);
  m_window->OpenGLInitContext();
  m_window->SetReadyForRendering(true);
}

void GlWindow::detach() {
  if (!m_widget) return;
  m_window->SetReadyForRendering(false);
  m_window->Finalize();
  m_widget = nullptr;
}

void GlWindow::draw(const QSize& size) {
  vtkOpenGLState* state = m_window->GetState();
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);
  m_window->SetSize(size.width(), size.height());
  m_window->Render();
  copy();
  state->Pop();
}

void GlWindow::drawAgain() {
  vtkOpenGLState* state = m_window->GetState();
  state->Reset();
  state->Push();
  copy();
  state->Pop();
}

void GlWindow::copy() {
  m_widget->makeCurrent();
  QOpenGLExtraFunctions* gl = m_widget->context()->extraFunctions();
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_widget->defaultFramebufferObject());
  const GLenum target = GL_COLOR_ATTACHMENT0;
  gl->glDrawBuffers(1, &target);
  m_window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  m_window->BlitDisplayFramebuffer();
  // VTK leaves alpha below one where it blended; the desktop would shine through.
  gl->glBindFramebuffer(GL_FRAMEBUFFER, m_widget->defaultFramebufferObject());
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace handwheel
