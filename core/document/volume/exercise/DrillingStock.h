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

// A volume that is drilled in an exercise, and its JSON form. Within the description of the exercise it is {"voxel",
// "origin", "data"}, the data as VolumeSerialization.h has it, compressed by zlib, in Base64. To make one takes a
// second for a large volume.
class DrillingStock {
 public:
  DrillingStock(SparseVolume volume, std::shared_ptr<const nlohmann::json> json);

  const SparseVolume& volume() const { return m_volume; }
  const std::shared_ptr<const nlohmann::json>& json() const { return m_json; }
  // Its surface for the view of the exercise, no wall torn. It is made at the first call, which takes about as long as
  // the stock itself; copies have it, too. Any thread.
  std::shared_ptr<const TriangleSoup> shown() const;

 private:
  struct Shown;

  SparseVolume m_volume;
  std::shared_ptr<const nlohmann::json> m_json;
  std::shared_ptr<Shown> m_shown;
};

// Bytes of the data before they are compressed, and the most of which a stock is read.
std::size_t stockBytes(const SparseVolume& volume);
inline constexpr std::size_t kLargestStock = std::size_t{1} << 30;

DrillingStock stockOf(const SparseVolume& volume);
// Any JSON. Error: ElementMalformed.
Result<DrillingStock> stockFrom(const nlohmann::json& json);

}  // namespace handwheel
