// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/DisplayModel.h"

namespace handwheel {

Box DisplayModel::bounds() const {
  Box box;
  for (const DisplayPart& part : parts) {
    for (const Vec3& p : part.soup->points) box.extend(part.pose * p);
  }
  return box;
}

}  // namespace handwheel
