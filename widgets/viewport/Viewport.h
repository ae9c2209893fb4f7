// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/CameraState.h"
#include "viewport/ViewportTypes.h"

#include <QImage>
#include <QOpenGLWidget>
#include <memory>

namespace handwheel {

// Draws one mesh with the marks on it, lets the mouse move the camera and tells what is under the cursor. All calls
// belong to the window thread. Lengths and positions are in units of the model (mm).
class Viewport : public QOpenGLWidget {
  Q_OBJECT
 public:
  // To be called once before QApplication is constructed: sets the surface format and asks for GLX, the only window
  // system interface that the renderer speaks.
  static void prepareApplication();

  // Why this application cannot show a viewport at all, as a translated sentence; empty when it may. To be asked before
  // one is constructed: on Qt's offscreen platform, a window with a QOpenGLWidget in it crashes (seen with Qt 6.4).
  static QString platformProblem();

  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  // Shows another model. The camera stays, and leaps instead of flying where it is sent next. Returns at once, the
  // parts appear over the next frames.
  void setMesh(const HalfEdgeMesh& mesh);
  // The same for who knows the bounds of the live faces already: a large mesh takes its time to measure.
  void setMesh(const HalfEdgeMesh& mesh, const Box& bounds);
  // The same model after an edit that touched these faces (added, removed, turned or with moved corners). Rebuilds only
  // the blocks concerned.
  void updateMesh(const HalfEdgeMesh& mesh, const std::vector<Face>& touched);
  // Removes the model and every mark.
  void clear();

  void setLoops(std::vector<LoopMark> loops);
  void setFaceMarks(std::vector<FaceMark> marks);
  void setPointMarks(std::vector<PointMark> marks);
  void setLineMarks(std::vector<LineMark> marks);
  // A translucent patch over the model, for what an operation would add. Empty removes it.
  void setPreview(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
  // Draws this loop as under the cursor, for hovering in a list; -1 for none.
  void setHighlightedLoop(int id);

  void setShading(Shading shading);
  Shading shading() const;
  void setDarkTheme(bool dark);

  void setStandardView(StandardView view);  // whole model from this side, animated
  void fit();                               // whole model from the present side, animated
  // Something covers this many pixels at the lower edge: what is fitted keeps clear of them. A model that was fitted
  // and not moved since makes room at once.
  void setCovered(int pixels);
  // Looks at the box from outside, animated. outward need not be of unit length; zero keeps the direction.
  void flyTo(const Box& box, const Vec3& outward);
  CameraState camera() const;  // where the camera is, or where its present flight will end
  void setCamera(const CameraState& camera);

  // The picture as shown, in device pixels. Waits until the whole model is uploaded.
  QImage grabImage();
  // What is at this position of the widget. Nothing as long as the model's search structure is being built.
  Pick pickAt(const QPointF& position) const;
  bool isPickingReady() const;

  // Why nothing can be drawn, as a translated sentence; empty when all is well.
  QString graphicsProblem() const;
  // How often a block of the mesh has been built since the construction; for tests of updateMesh.
  int blocksBuilt() const;

  QSize sizeHint() const override;

 signals:
  void hovered(const handwheel::Pick& pick);  // also when it becomes nothing
  void clicked(const handwheel::Pick& pick, Qt::KeyboardModifiers modifiers);
  void doubleClicked(const handwheel::Pick& pick);
  void cameraChanged();
  void graphicsFailed(const QString& problem);

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  class Private;
  std::unique_ptr<Private> d;
};

}  // namespace handwheel
