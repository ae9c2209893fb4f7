// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

namespace handwheel {

// Optional interface of a KindUi that opens files beside its documents. KindUi::take() opens them, for example programs
// that run on a document.
class CompanionFiles {
 public:
  virtual ~CompanionFiles() = default;

  // The message of the window about a companion file while no document of this kind is current. It offers a new
  // document, or one that is open.
  struct Offer {
    QString title, detail, advice, action;
  };
  virtual std::optional<Offer> companionOffer(const QString& path) const = 0;
  // Returns a filter for the dialog that opens files: "Programs (*.ngc)".
  virtual QString companionFilter() const = 0;
};

}  // namespace handwheel
