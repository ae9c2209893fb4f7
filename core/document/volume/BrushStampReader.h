// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/DocumentKind.h"
#include "volume/clay/ClayStamp.h"

#include <filesystem>

namespace handwheel {

// Reads a stamp from a picture, or from a document with a surface. The heights are the brightness of a picture (PNG,
// JPEG, BMP, GIF, PNM), where transparent pixels are black, or the heights of a surface over the xy plane. Large stamps
// are reduced to ClayStamp::kMostSide. Errors: FileMissing, FileUnreadable; FileTooLarge beyond kMostStampBytes or
// kMostStampPixels; VolumeErrors::PictureUnreadable, VolumeErrors::NothingStandsOut; the errors of
// DocumentKinds::open(); Cancelled.
Result<std::shared_ptr<const ClayStamp>> readBrushStamp(const std::filesystem::path& path, const DocumentKinds& kinds,
                                                        Progress progress = {});

inline constexpr std::size_t kMostStampBytes = std::size_t{64} << 20;  // largest size of a picture's file
inline constexpr std::size_t kMostStampPixels = std::size_t{32}
                                                << 20;  // largest number of pixels; each takes four bytes when unpacked

}  // namespace handwheel
