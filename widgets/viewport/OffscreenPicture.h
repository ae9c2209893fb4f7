// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/DisplayModel.h"
#include "viewport/MeshMarks.h"
#include "viewport/overlay/ColourScale.h"

#include <QImage>
#include <filesystem>
#include <span>

namespace handwheel {

// The default view direction of pictures: from the front right above. It is fixed, so that pictures of a part before
// and after a repair can be compared.
inline const Vec3 kPictureSide{1.0, -1.0, 1.0};

// Renders a mesh with its loops, or parts. The picture includes axes and scale bar. No widget or application object is
// needed, but an X display with GLX. outward: the direction from the model to the viewer; it need not be of unit
// length, z is up. Errors: WriteFailed {reason} if there is no such display, OutOfMemory. They name no file.
Result<QImage> renderPicture(const HalfEdgeMesh& mesh, const std::vector<LoopMark>& loops, const QSize& size,
                             const Vec3& outward = kPictureSide);
Result<QImage> renderPicture(const DisplayModel& model, const QSize& size, const Vec3& outward = kPictureSide);

// Renders a mesh from several sides, coloured by values, with the colour scale. Errors: the errors of renderPicture(),
// Cancelled.
Result<std::vector<QImage>> renderSides(const HalfEdgeMesh& mesh, const VertexValues& atVertex,
                                        const ColourScale& scale, std::span<const Vec3> outward, const QSize& size,
                                        Progress progress = {});

// Writes an image, which must not be null, to a PNG file. Errors: WriteFailed {reason}, OutOfMemory.
Status savePng(const QImage& picture, const std::filesystem::path& png);

}  // namespace handwheel
