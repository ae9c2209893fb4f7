// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

namespace handwheel {

// Optional interface of a KindUi that opens files beside its documents. KindUi::take() opens them; an example are
// programs that are to run on a document.
class CompanionFiles {
 public:
  virtual ~CompanionFiles() = default;

  // What the window says and offers for such a file while no document of this kind is current: a new document of it, or
  // one that is open. None: it is no such file.
  struct Offer {
    QString title, detail, advice, action;
  };
  virtual std::optional<Offer> companionOffer(const QString& path) const = 0;
  // For the dialog that opens files: "Programs (*.ngc)".
  virtual QString companionFilter() const = 0;
};

}  // namespace handwheel
