// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/DocumentKind.h"
#include "volume/clay/ClayStamp.h"

#include <filesystem>

namespace handwheel {

// Reads a stamp from a picture, or from a document with a surface. Of a picture (PNG, JPEG, BMP, GIF, PNM)
// heights are the brightness, and what is transparent is black; of others they are those over the xy plane. Both are
// reduced to ClayStamp::kMostSide. Errors: FileMissing, FileUnreadable; FileTooLarge beyond kMostStampBytes or
// kMostStampPixels; PictureUnreadable, NothingStandsOut of VolumeErrors; those of DocumentKinds::open(); Cancelled.
Result<std::shared_ptr<const ClayStamp>> readBrushStamp(const std::filesystem::path& path, const DocumentKinds& kinds,
                                                        Progress progress = {});

inline constexpr std::size_t kMostStampBytes = std::size_t{64} << 20;   // of the file of a picture
inline constexpr std::size_t kMostStampPixels = std::size_t{32} << 20;  // four bytes each once it is unpacked

}  // namespace handwheel
