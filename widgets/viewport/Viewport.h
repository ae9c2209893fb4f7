// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/ThreadClock.h"
#include "document/DisplayModel.h"
#include "mesh/FaceSelection.h"
#include "viewport/CameraState.h"
#include "viewport/ClipPlane.h"
#include "viewport/ColourScale.h"
#include "viewport/DeviceCursor.h"
#include "viewport/NavigationPreset.h"
#include "viewport/ViewportTypes.h"

#include <QImage>
#include <QOpenGLWidget>
#include <functional>
#include <memory>

namespace handwheel {

struct LiveMesh;

// Draws a mesh, rigid parts or both with the marks on them, lets the mouse move the camera and tells what is under the
// cursor. All calls belong to the window thread. Lengths and positions are in units of the model (mm).
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

  // How many faces are built and drawn together, from the next setMesh() on: the setting view.block_faces.
  void setBlockFaces(Face faces);
  // Roughly how many triangles a slow display draws of a large mesh while the camera moves, from the next setMesh() or
  // edit on: the setting view.coarse_triangles.
  void setCoarseTriangles(std::size_t triangles);

  // Shows another model. The camera stays, and leaps instead of flying where it is sent next. Returns at once, the
  // parts appear over the next frames.
  void setMesh(const HalfEdgeMesh& mesh);
  // The same for who knows the bounds of the live faces already: a large mesh takes its time to measure.
  void setMesh(const HalfEdgeMesh& mesh, const Box& bounds);
  // The same model after an edit that touched these faces (added, removed, turned or with moved corners). Rebuilds only
  // the blocks concerned.
  void updateMesh(const HalfEdgeMesh& mesh, const std::vector<Face>& touched);
  // Colours the mesh by a value to each vertex slot, with a legend, until it changes or is replaced; null ends it. The
  // blocks change colour over the next frames.
  void setSurfaceValues(VertexValues values, const ColourScale& scale);
  // Another scale for them; builds no geometry anew.
  void setColourScale(const ColourScale& scale);
  // Shows these parts, beside the mesh if there is one. Returns at once. A part whose soup is still the same object is
  // moved, not built anew; one whose soup changed keeps its former shape until the new one has been built.
  void setParts(const DisplayModel& model);
  // Removes mesh, parts and every mark.
  void clear();
  Box bounds() const;  // of mesh and parts

  void setLoops(std::vector<LoopMark> loops);
  void setFaceMarks(std::vector<FaceMark> marks);
  void setPointMarks(std::vector<PointMark> marks);
  void setLineMarks(std::vector<LineMark> marks);
  // The outline of a cut, on the model.
  void setSection(std::vector<SectionMark> section);
  // A translucent patch over the model, for what an operation would add. Empty removes it.
  void setPreview(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
  // Draws this loop as under the cursor, for hovering in a list; -1 for none.
  void setHighlightedLoop(int id);

  // Faces of the mesh that are selected, and those that a tool points out; until they are set anew.
  void setSelectedFaces(const FaceSelection& faces);
  void setHighlightedFaces(const FaceSelection& faces);
  // Another version in the place of the mesh, as long as a tool works on it; null for none. Nothing else follows it:
  // marks and what is picked are those of the mesh. Takes as long to appear as its blocks take to be built, and is left
  // out when the next comes sooner.
  void setLiveMesh(const std::shared_ptr<const LiveMesh>& live);
  // What a tool proposes, translucent.
  void setProposedParts(const std::vector<DisplayPart>& parts);
  // Lines over everything: a lasso, a ruler.
  void setPolylines(std::vector<std::vector<Vec3>> lines);
  // A circle that follows the surface around its centre.
  void setBrush(const std::optional<BrushCircle>& brush);

  // The cursor of a haptic device, over everything; its shadow and what hides it are found here. None: no device. The
  // model is not drawn anew for it.
  void setDeviceCursor(const std::optional<DeviceCursor>& cursor);

  void setShading(Shading shading);
  Shading shading() const;
  void setDarkTheme(bool dark);
  // What lies beyond the plane is neither drawn nor picked. Its offsets across the model: clipOffsets(bounds(),
  // normal).
  void setClipPlane(const ClipPlane& plane);
  const ClipPlane& clipPlane() const;
  // In which the scale bar measures.
  void setDisplayUnit(LengthUnit unit);
  void setViewCubeVisible(bool visible);

  void setStandardView(StandardView view);  // whole model from this side, animated
  void fit();                               // whole model from the present side, animated
  // Something covers this many pixels at the lower edge: what is fitted keeps clear of them. A model that was fitted
  // and not moved since makes room at once.
  void setCovered(int pixels);
  // Looks at the box from outside, animated. outward need not be of unit length; zero keeps the direction.
  void flyTo(const Box& box, const Vec3& outward);
  CameraState camera() const;  // where the camera is, or where its present flight will end
  void setCamera(const CameraState& camera);
  // The same picture at the focus, under the other projection. It is a part of the camera's state: setCamera() may
  // change it, too.
  void setProjection(Projection projection);
  Projection projection() const { return camera().projection; }

  void setNavigationPreset(NavigationPreset preset);
  NavigationPreset navigationPreset() const;
  // Input and effect, translated: for the hint bar.
  std::vector<std::pair<QString, QString>> navigationHints() const;
  // The sink hears of the mouse before the camera does, and returns whether it wants the event for itself. What it
  // takes as a press is its until that button is released: all moves, and the release. Of what the camera follows it
  // hears nothing. Null for none.
  void setPointerSink(std::function<bool(const PointerInput&)> sink);

  // The picture as shown, in device pixels. Waits until the whole model is uploaded.
  QImage grabImage();
  // What is at this position of the widget. Nothing as long as the search structure of the mesh is being built; no part
  // whose own is.
  Pick pickAt(const QPointF& position) const;
  // The first surface along a ray, for tools; no loops. The direction is of unit length.
  Pick pickAlong(const Vec3& origin, const Vec3& direction) const;
  bool isPickingReady() const;
  ViewRay rayAt(const QPointF& position) const;

  // Why nothing can be drawn, as a translated sentence; empty when all is well.
  QString graphicsProblem() const;
  // How often a block of the mesh or of a part has been built, and a frame drawn, since the construction; for tests.
  int blocksBuilt() const;
  int framesDrawn() const;
  Spent timeDrawing() const;  // in the renderer so far, for measurements

  QSize sizeHint() const override;

 signals:
  void hovered(const handwheel::Pick& pick);  // also when it becomes nothing
  void clicked(const handwheel::Pick& pick, Qt::KeyboardModifiers modifiers);
  void doubleClicked(const handwheel::Pick& pick);
  void cameraChanged();
  void clipPlaneChanged();
  void graphicsFailed(const QString& problem);

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintGL() override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  // Draws the model anew; what is asked for otherwise shows what was drawn last.
  void update();

  class Private;
  std::unique_ptr<Private> d;
};

}  // namespace handwheel
