// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace handwheel {

// An event filter that shows why a menu entry or button is disabled. The reason appears as a tool tip under the
// pointer. The reason is set by offer() in OfferedAction.h; widgets without a reason keep their own tool tip.
class DisabledReasons : public QObject {
  Q_OBJECT

 public:
  // Installs the filter on the application for the lifetime of this object.
  explicit DisabledReasons(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace handwheel
