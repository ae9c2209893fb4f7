// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/BodyGeometry.h"

#include <map>
#include <string>

namespace handwheel {

// A shape that this program cannot show. Its data are damaged, or its kind is unknown; they are kept as they were read,
// so that saving loses nothing.
class UnknownGeometry : public BodyGeometry {
 public:
  // description: the JSON of the shape. parts: its blobs by their names within the folder of the body. isDamaged: true
  // if the kind is known, but the data are damaged.
  UnknownGeometry(std::string kind, std::string description, std::map<std::string, std::string> parts,
                  bool isDamaged = false)
      : m_kind(std::move(kind)),
        m_description(std::move(description)),
        m_parts(std::move(parts)),
        m_isDamaged(isDamaged) {}

  bool isDamaged() const { return m_isDamaged; }

  const std::string& description() const { return m_description; }
  const std::map<std::string, std::string>& parts() const { return m_parts; }

  std::string_view kind() const override { return m_kind; }
  std::size_t bytes() const override;
  bool isKnown() const override { return false; }

 protected:
  std::shared_ptr<const TriangleSoup> makeSurface() const override { return std::make_shared<const TriangleSoup>(); }

 private:
  std::string m_kind;
  std::string m_description;
  std::map<std::string, std::string> m_parts;
  bool m_isDamaged;
};

}  // namespace handwheel
