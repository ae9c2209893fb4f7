// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SparseVolume.h"

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// A volume that is drilled in an exercise, and its JSON form. In the description of an exercise it is {"voxel",
// "origin", "data"}, where the data are those of VolumeSerialization.h, compressed by zlib, in Base64. Construction
// takes a second for a large volume.
class DrillingStock {
 public:
  DrillingStock(SparseVolume volume, std::shared_ptr<const nlohmann::json> json);

  const SparseVolume& volume() const { return m_volume; }
  const std::shared_ptr<const nlohmann::json>& json() const { return m_json; }
  // Returns the surface for the view of the exercise. It is coarser than the volume if the volume is large. The first
  // call makes the surface, which takes about as long as the construction of the stock; copies share it. May be called
  // on any thread.
  std::shared_ptr<const TriangleSoup> shown() const;

 private:
  struct Shown;

  SparseVolume m_volume;
  std::shared_ptr<const nlohmann::json> m_json;
  std::shared_ptr<Shown> m_shown;
};

// Returns the size of the data before compression, bytes. When a stock is read, the limit of this size is
// kLargestStock.
std::size_t stockBytes(const SparseVolume& volume);
inline constexpr std::size_t kLargestStock = std::size_t{1} << 30;

DrillingStock stockOf(const SparseVolume& volume);
// Reads a stock; the input is not trusted. Error: ElementMalformed.
Result<DrillingStock> stockFrom(const nlohmann::json& json);

}  // namespace handwheel
