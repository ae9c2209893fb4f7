// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/DisplayModel.h"
#include "viewport/ColourScale.h"
#include "viewport/ViewportTypes.h"

#include <QImage>
#include <filesystem>
#include <span>

namespace handwheel {

// From the front right above, so that pictures of a part before and after a repair can be compared.
inline const Vec3 kPictureSide{1.0, -1.0, 1.0};

// Renders the mesh with its loops, or the parts, with axes and scale bar to a PNG of width × height pixels: without a
// widget and without an application object. outward: on which side of the model the viewer stands; it need not be of
// unit length, z is up. Needs an X display with GLX; WriteFailed {reason} when there is none or the file cannot be
// written.
Status renderToFile(const HalfEdgeMesh& mesh, const std::vector<LoopMark>& loops, const std::filesystem::path& png,
                    int width, int height, const Vec3& outward = kPictureSide);
Status renderToFile(const DisplayModel& model, const std::filesystem::path& png, int width, int height,
                    const Vec3& outward = kPictureSide);

// Pictures of the mesh from several sides, coloured by the values, with the scale. Errors: WriteFailed {reason} as
// above, Cancelled.
Result<std::vector<QImage>> renderSides(const HalfEdgeMesh& mesh, const VertexValues& atVertex,
                                        const ColourScale& scale, std::span<const Vec3> outward, const QSize& size,
                                        Progress progress = {});

// Error: WriteFailed {reason}.
Status savePng(const QImage& picture, const std::filesystem::path& png);

}  // namespace handwheel
