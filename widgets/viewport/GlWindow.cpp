// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/GlWindow.h"

#include <vtkCommand.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLWidget>

namespace handwheel {

GlWindow::GlWindow(vtkRenderer* renderer) {
  m_window->SetFrameBlitModeToNoBlit();
  m_window->SetReadyForRendering(false);
  m_window->SetMultiSamples(0);
  m_window->AddRenderer(renderer);
  m_window->AddObserver(vtkCommand::WindowMakeCurrentEvent, this, &GlWindow::makeContextCurrent);
  // Unanswered, Render() silently does nothing.
  m_window->AddObserver(vtkCommand::WindowIsCurrentEvent, this, &GlWindow::reportIsCurrent);
}

GlWindow::~GlWindow() {
  m_window->RemoveAllObservers();
}

// Not the widget's makeCurrent(): that also binds Qt's framebuffer, and VTK asks in the middle of building its own.
void GlWindow::makeContextCurrent() {
  if (m_context && m_context->surface()) m_context->makeCurrent(m_context->surface());
}

void GlWindow::reportIsCurrent(vtkObject*, unsigned long, void* isCurrent) {
  *static_cast<bool*>(isCurrent) = m_context && QOpenGLContext::currentContext() == m_context;
}

void GlWindow::attach(QOpenGLContext* context) {
  m_context = context;
  vtkOpenGLState* state = m_window->GetState();
  state->Reset();
  // VTK expects LEQUAL as the rest state, Qt leaves LESS.
  state->vtkglDepthFunc(GL_LEQUAL);
  m_window->SetOwnContext(0);
  m_window->OpenGLInitContext();
  m_window->SetReadyForRendering(true);
}

void GlWindow::detach() {
  if (!m_context) return;
  m_window->SetReadyForRendering(false);
  m_window->Finalize();
  m_context = nullptr;
}

void GlWindow::draw(QOpenGLWidget* widget, const QSize& size) {
  vtkOpenGLState* state = m_window->GetState();
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);
  m_window->SetSize(size.width(), size.height());
  m_window->Render();

  widget->makeCurrent();
  QOpenGLExtraFunctions* gl = m_context->extraFunctions();
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, widget->defaultFramebufferObject());
  const GLenum target = GL_COLOR_ATTACHMENT0;
  gl->glDrawBuffers(1, &target);
  state->vtkglDisable(GL_SCISSOR_TEST);
  m_window->BlitDisplayFramebuffer();
  // VTK leaves alpha below one where it blended; the desktop would shine through.
  gl->glBindFramebuffer(GL_FRAMEBUFFER, widget->defaultFramebufferObject());
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->Pop();
}

}  // namespace handwheel
