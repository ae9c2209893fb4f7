// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/OffscreenPicture.h"

#include "document/AtomicFile.h"
#include "viewport/DisplayCheck.h"
#include "viewport/Scene.h"
#include "viewport/overlay/Overlay.h"
#include "viewport/surface/MeshLayer.h"
#include "viewport/surface/PartsLayer.h"

#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <QBuffer>
#include <algorithm>

namespace handwheel {

namespace {

constexpr double kShare = 0.86;  // share of the picture, filled by the model

Error writeFailed(std::string reason) {
  return {ErrorCode::WriteFailed, {std::move(reason)}, {}, {}};
}

CameraState wholeModel(const Scene& scene, const Vec2& size, const Vec3& outward) {
  CameraState camera;
  camera.orientation = uprightTowards(outward);
  return CameraNavigation(camera, size).fitted(scene.outline(), kShare);
}

Result<QImage> render(Scene& scene, int width, int height) {
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  window->AddRenderer(scene.renderer());
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, width - 1, height - 1, 0, pixels);
  window->RemoveRenderer(scene.renderer());
  if (pixels->GetNumberOfTuples() != vtkIdType{width} * height) return writeFailed("the picture could not be rendered");
  const QImage rows(pixels->GetPointer(0), width, height, 3 * width, QImage::Format_RGB888);
  QImage picture = rows.mirrored();  // rows come from below; this copies, and is null if there is no memory for it
  if (picture.isNull()) return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  return picture;
}

// Renders the scene with axes and scale bar.
Result<QImage> drawn(Scene& scene, const QSize& size, const Vec3& outward) {
  while (scene.uploadPendingGeometry()) {
  }
  const Vec2 pixels(size.width(), size.height());
  const CameraState camera = wholeModel(scene, pixels, outward);
  scene.prepare(camera, pixels, 1.0);
  Result<QImage> picture = render(scene, size.width(), size.height());
  if (!picture) return picture;
  QPainter painter(&*picture);
  paintOverlay(painter, picture->size(), camera, LengthUnit::Millimetre, scene.colours());
  scene.paintOver(painter, picture->size(), LengthUnit::Millimetre);
  return picture;
}

// make: builds the layer to be shown.
template <class Make>
Result<QImage> renderLayer(const Make& make, const QSize& size, const Vec3& outward) {
  if (size.isEmpty()) return writeFailed("the picture has no pixels");
  const DisplayCheck display;
  if (!display.problem().empty()) return writeFailed(display.problem());
  Scene scene;
  scene.add(make());
  return drawn(scene, size, outward);
}

}  // namespace

Result<QImage> renderPicture(const HalfEdgeMesh& mesh, const std::vector<LoopMark>& loops, const QSize& size,
                             const Vec3& outward) {
  const auto make = [&] {
    const auto layer = std::make_shared<MeshLayer>();
    layer->setMeshAtOnce(mesh, nullptr, {});
    layer->setLoops(loops);
    return layer;
  };
  return renderLayer(make, size, outward);
}

Result<QImage> renderPicture(const DisplayModel& model, const QSize& size, const Vec3& outward) {
  const auto make = [&] {
    const auto layer = std::make_shared<PartsLayer>();
    layer->setPartsAtOnce(model.parts);
    return layer;
  };
  return renderLayer(make, size, outward);
}

Result<std::vector<QImage>> renderSides(const HalfEdgeMesh& mesh, const VertexValues& atVertex,
                                        const ColourScale& scale, std::span<const Vec3> outward, const QSize& size,
                                        Progress progress) {
  const DisplayCheck display;
  if (!display.problem().empty()) return writeFailed(display.problem());
  Scene scene;
  const auto layer = std::make_shared<MeshLayer>();
  layer->setMeshAtOnce(mesh, atVertex, scale);
  scene.add(layer);
  std::vector<QImage> pictures;
  for (const Vec3& side : outward) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    Result<QImage> picture = drawn(scene, size, side);
    if (!picture) return picture.error();
    pictures.push_back(std::move(*picture));
    progress.set(static_cast<double>(pictures.size()) / static_cast<double>(outward.size()));
  }
  return pictures;
}

Status savePng(const QImage& picture, const std::filesystem::path& png) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, "PNG")) return Error{ErrorCode::OutOfMemory, {}, {}, {}};  // nothing else fails here
  return writeFileAtomically(png, {buffer.data().constData(), static_cast<std::size_t>(buffer.size())});
}

}  // namespace handwheel
