// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/BodySet.h"

namespace handwheel {

// Interface of documents that hold bodies. A document derives from Document and BodyOwner; BodyEdit changes its bodies.
class BodyOwner {
 public:
  const BodySet& bodies() const { return m_bodies; }

 protected:
  explicit BodyOwner(BodySet bodies) : m_bodies(std::move(bodies)) {}
  ~BodyOwner() = default;

 private:
  friend class BodyEdit;
  virtual void bodiesChanged() = 0;  // Implementations must call Document::wasChanged()

  BodySet m_bodies;
};

}  // namespace handwheel
